import { readConversation } from '../diagnosis/index.ts';
import { sameBytes } from '../modbus/index.ts';
import type { TextProblem } from '../notation/index.ts';
import { type CaptureRecord, type Reason, reasons } from '../trace/index.ts';
import { LogClock, type PrintedClock } from './clock.ts';
import { readLongLog, readShortLog } from './long-log.ts';
import type { CaptureProblem } from './packet.ts';

/** More problems than this are not listed each. */
const MOST_PROBLEMS = 1000;

/** Characters of a log of many lines. */
const LONG = 1_000_000;
/** The part of the time that goes into reading the bytes. */
const BYTES = 0.8;
/** Characters that are kept of words that are not bytes. */
const MOST_TEXT = 80;

/** What is in no frame: the problem that says so, as a record of noise, and the record before which it stands, by its index. */
export interface UnframedPiece {
  readonly before: number;
  readonly problem: CaptureProblem;
  readonly record: CaptureRecord;
}

/**
 * The frames of a text, as `readBytes` reads it; those that are damaged too. Bytes in which no frame is seen are problems. `tell` hears
 * which part is done.
 */
export function readLog(
  text: string,
  tell?: (done: number) => void,
): {
  readonly records: CaptureRecord[];
  readonly problems: CaptureProblem[];
  readonly pieces: UnframedPiece[];
  readonly clock: PrintedClock | undefined;
} {
  const read = text.length > LONG ? readLongLog : readShortLog;
  const { bytes, chunks, problems, place: placeOf } = read(text, tell && ((done) => tell(done * BYTES)));
  const records: CaptureRecord[] = [];
  const unread: Unread[] = [];
  const clock = new LogClock();
  let chunk = 0;
  let timed = -1;
  let time: number | undefined;
  let sent: Uint8Array | undefined;
  for (const item of readConversation(bytes, chunks, tell && ((done) => tell(BYTES + done * (1 - BYTES))))) {
    while (chunk + 1 < chunks.length && (chunks[chunk]?.to ?? 0) <= item.from) chunk++;
    const { start, end } = placeOf(item.from, item.to);
    const place = { kind: 'text', from: start, to: end } as const;
    if (timed !== chunk) {
      time = clock.read(chunks[chunk]?.time);
      timed = chunk;
    }
    const own = bytes.subarray(item.from, item.to);
    // A bare PDU has no place in a conversation.
    if (item.kind === 'unread' || item.transport === 'pdu') {
      unread.push({ code: 'no-frame', place, bytes: own, time });
      continue;
    }
    const said = chunks[chunk]?.direction;
    const { transport, direction } = item;
    // What was received, and is the request that was just sent, is the adapter's echo and no second request.
    const isEcho = direction === 'request' && said === 'response' && sent !== undefined && sameBytes(sent, own);
    const side = isEcho ? 'response' : direction;
    sent = side === 'request' && said === 'request' ? own : undefined;
    records.push({
      bytes: own,
      ...(time !== undefined && { time: clock.since(time) }),
      side,
      transport,
      place,
    });
  }
  const words = wordsIn(text, problems.slice(0, MOST_PROBLEMS));
  return { records, ...piecesOf(text, records, [...words, ...unread], clock), clock: clock.printed };
}

interface Unread extends CaptureProblem {
  readonly place: Extract<CaptureRecord['place'], { readonly kind: 'text' }>;
  readonly bytes?: Uint8Array;
  /** As the clock has it. */
  readonly time?: number | undefined;
}

const isReason = (code: string): code is Reason => reasons.some((one) => one === code);

/** The problems of a text; those of the same kind that follow each other in a line are one. */
function wordsIn(text: string, problems: readonly TextProblem[]): readonly Unread[] {
  const found: Unread[] = [];
  for (const { start, end, code, ...data } of problems.toSorted((one, other) => one.start - other.start)) {
    const last = found.at(-1);
    const goesOn = isReason(code) && last?.code === code && !text.slice(last.place.to, start).includes('\n');
    if (goesOn) found.pop();
    found.push({ ...data, code, place: { kind: 'text', from: goesOn ? last.place.from : start, to: end } });
  }
  return found;
}

/** What is wrong with a text, and which of it are pieces of it in no frame, each between the frames where it stands. */
function piecesOf(text: string, records: readonly CaptureRecord[], unread: readonly Unread[], clock: LogClock) {
  const problems: CaptureProblem[] = [];
  const pieces: UnframedPiece[] = [];
  const from = ({ place }: CaptureRecord) => (place.kind === 'text' ? place.from : 0);
  let [before, line, lineEnd] = [0, 1, text.indexOf('\n')];
  for (const { bytes, time, ...problem } of unread.toSorted((one, other) => one.place.from - other.place.from)) {
    problems.push(problem);
    const { code, place } = problem;
    if (!isReason(code)) continue;
    for (let record = records[before]; record && from(record) < place.from; record = records[before]) before++;
    for (; lineEnd >= 0 && lineEnd < place.from; lineEnd = text.indexOf('\n', lineEnd + 1)) line++;
    // A part of a text would keep all of it.
    const words = bytes ? undefined : Array.from(text.slice(place.from, Math.min(place.to, place.from + MOST_TEXT)));
    const record: CaptureRecord = {
      bytes: bytes ?? new Uint8Array(0),
      ...(time !== undefined && { time: clock.since(time) }),
      transport: records[before]?.transport ?? records.at(-1)?.transport ?? 'rtu',
      place,
      known: { beside: 'noise', why: code, ...(words && { text: words.join('') }), line },
    };
    pieces.push({ before, problem, record });
  }
  return { problems, pieces };
}
