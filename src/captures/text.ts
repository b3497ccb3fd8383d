import { readConversation } from '../diagnosis/index.ts';
import type { CaptureRecord } from '../trace/index.ts';
import { LogClock } from './clock.ts';
import { readLongLog, readShortLog } from './long-log.ts';
import type { CaptureProblem } from './packet.ts';

/** More problems than this are not listed each. */
const MOST_PROBLEMS = 1000;

/** Characters of a log of many lines. */
const LONG = 1_000_000;
/** The part of the time that goes into reading the bytes. */
const BYTES = 0.8;

/**
 * The frames of a text, as `readBytes` reads it; those that are damaged too. Bytes in which no frame is seen are problems. `tell` hears
 * which part is done.
 */
export function readLog(
  text: string,
  tell?: (done: number) => void,
): { readonly records: CaptureRecord[]; readonly problems: CaptureProblem[]; readonly clock: number } {
  const read = text.length > LONG ? readLongLog : readShortLog;
  const { bytes, chunks, problems, place: placeOf } = read(text, tell && ((done) => tell(done * BYTES)));
  const records: CaptureRecord[] = [];
  const unread: CaptureProblem[] = problems.slice(0, MOST_PROBLEMS).map(({ start, end, code, ...data }) => ({
    ...data,
    code,
    place: { kind: 'text', from: start, to: end },
  }));
  const clock = new LogClock();
  let chunk = 0;
  let timed = -1;
  let time: number | undefined;
  for (const item of readConversation(bytes, chunks, tell && ((done) => tell(BYTES + done * (1 - BYTES))))) {
    while (chunk + 1 < chunks.length && (chunks[chunk]?.to ?? 0) <= item.from) chunk++;
    const { start, end } = placeOf(item.from, item.to);
    const place = { kind: 'text', from: start, to: end } as const;
    if (item.kind === 'unread') {
      unread.push({ code: 'no-frame', place });
      continue;
    }
    if (timed !== chunk) {
      time = clock.read(chunks[chunk]?.time);
      timed = chunk;
    }
    const { transport, direction: side } = item;
    // A bare PDU has no place in a conversation.
    if (transport === 'pdu') {
      unread.push({ code: 'no-frame', place });
      continue;
    }
    records.push({
      bytes: bytes.subarray(item.from, item.to),
      ...(time === undefined ? undefined : { time }),
      side,
      transport,
      place,
    });
  }
  return { records, problems: unread, clock: clock.first };
}
