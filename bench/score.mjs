/**
 * How well the frames of a stream were found: of those intact how many, how many that were never sent so, and of how many
 * the direction is right, among those found whose direction the stream can tell. Frames whose length no byte tells, and
 * what is found inside of them, are not scored.
 * @param {{ from: number, to: number, direction?: string }[]} found
 * @param {ReturnType<typeof import('./traffic.mjs').damage>['frames']} frames
 */
export function score(found, frames) {
  const sent = new Map(frames.filter(({ intact }) => intact).map((frame) => [`${frame.from}-${frame.to}`, frame]));
  const unscored = frames.filter(({ scored }) => !scored);
  const places = new Map(frames.map((frame, i) => [frame, i]));
  const result = { intact: 0, found: 0, false: 0, tellable: 0, right: 0, wrong: 0 };
  result.intact = frames.filter(({ intact, scored }) => intact && scored).length;
  for (const { from, to, direction } of found) {
    const frame = sent.get(`${from}-${to}`);
    if (frame === undefined) {
      if (!unscored.some((open) => from >= open.from && to <= open.to)) result.false++;
    } else if (frame.scored) {
      result.found++;
      if (direction !== undefined && direction !== frame.direction) result.wrong++;
      const place = places.get(frame);
      if (!canBeTold(frame, frames[place - 1], frames[place + 1])) continue;
      result.tellable++;
      if (direction === frame.direction) result.right++;
    }
  }
  return result;
}

/** Functions whose reply may be their request in every byte. */
const ECHOES = new Set([5, 6, 8, 21, 22]);

/** Whether anything tells a frame's direction: its own form, or a neighbour on the line that is intact. */
const canBeTold = ({ functionCode }, before, after) =>
  Boolean(!ECHOES.has(functionCode) || before?.intact || after?.intact);
