/**
 * How well frames were found: of those intact and scored how many, how many that were never sent, and how many of the
 * found have the right direction, among all of them and among those where the stream can tell it.
 * @param {{ from: number, to: number, direction?: string }[]} found
 * @param {ReturnType<typeof import('./traffic.mjs').damage>} stream
 */
export function score(found, { bytes, frames }) {
  const sent = new Map(frames.filter(({ intact }) => intact).map((frame) => [`${frame.from}-${frame.to}`, frame]));
  const unscored = frames.filter(({ scored }) => !scored);
  const result = { intact: 0, found: 0, false: 0, rightDirection: 0, wrongDirection: 0, tellable: 0, rightOfTellable: 0 };
  const hits = new Set();
  for (const { from, to, direction } of found) {
    const frame = sent.get(`${from}-${to}`);
    if (frame === undefined) {
      // What stands in a frame that is not scored is not scored either.
      if (!unscored.some((open) => from >= open.from && to <= open.to)) result.false++;
      continue;
    }
    if (!frame.scored) continue;
    hits.add(frame);
    if (direction === frame.direction) result.rightDirection++;
    else if (direction !== undefined) result.wrongDirection++;
    if (!tellable(frame, frames, bytes)) continue;
    result.tellable++;
    if (direction === frame.direction) result.rightOfTellable++;
  }
  result.intact = frames.filter(({ intact, scored }) => intact && scored).length;
  result.found = hits.size;
  return result;
}

/** Functions whose request and reply are alike in every byte. */
const ECHOES = new Set([5, 6, 8, 21, 22]);

/** Whether anything tells a frame's direction: its own form, or one of its neighbours on the line that is intact. */
function tellable(frame, frames) {
  if (!ECHOES.has(frame.functionCode)) return true;
  const index = frames.indexOf(frame);
  return Boolean(frames[index - 1]?.intact || frames[index + 1]?.intact);
}
