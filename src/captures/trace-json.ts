import { dictionary, fromHex, toHex } from '../modbus/index.ts';
import { type CaptureRecord, knownOf, readKnown, type TraceInput } from '../trace/index.ts';
import { clockOf, type PrintedClock, type TraceFile } from './clock.ts';

const FORMAT = 'framewright trace';
/** What older versions of the page saved of its bus: its lines have milliseconds, and directions for sides. */
const OLD_FORMAT = 'framewright log';
const TRANSPORTS: readonly CaptureRecord['transport'][] = ['rtu', 'ascii', 'tcp'];
const SIDES: Readonly<Record<string, CaptureRecord['side']>> = dictionary({
  request: 'request',
  response: 'response',
  sent: 'request',
  received: 'response',
});
const MILLISECOND = 1000;

/**
 * Records as a file of JSON, which `readCapture` reads again, in parts; times are microseconds, `at` says what a clock prints for them,
 * and bytes are digits, two each.
 */
export function* traceJsonParts(
  records: Iterable<TraceInput>,
  at?: (time: number) => string,
): Generator<string, void, undefined> {
  let before = `{"format":"${FORMAT}","version":1,"records":[`;
  for (const { bytes, time, side, transport, from, to, known } of records) {
    const printed = time === undefined ? undefined : at?.(time);
    yield `${before}\n${JSON.stringify({ time, at: printed, side, transport, from, to, known, bytes: toHex(bytes) })}`;
    before = ',';
  }
  yield `${before === ',' ? '' : before}\n]}\n`;
}

/** Such a file in one piece. */
export const writeTraceJson = (records: Iterable<TraceInput>): string => [...traceJsonParts(records)].join('');

/** The records of such a file, and the clock of their times; `undefined` if the text is not one. What is not a record is left out. */
export function readTraceJson(text: string): TraceFile | undefined {
  if (!/^\s*\{\s*"format"\s*:\s*"framewright (?:trace|log)"/.test(text)) return undefined;
  try {
    const { format, records, lines } = JSON.parse(text) as Readonly<Record<string, unknown>>;
    const [list, unit] = format === FORMAT ? [records, 1] : [format === OLD_FORMAT ? lines : undefined, MILLISECOND];
    if (!Array.isArray(list)) return undefined;
    const own = list.flatMap((one, index) => recordOf(one, index, unit) ?? []);
    return { records: own, clock: clockIn(list) };
  } catch {
    return undefined;
  }
}

/** The clock of the first record that says it. */
function clockIn(list: readonly unknown[]): PrintedClock | undefined {
  for (const one of list) {
    const { time, at } = (one ?? {}) as Readonly<Record<string, unknown>>;
    if (typeof time === 'number' && typeof at === 'string') return clockOf(at, time);
  }
  return undefined;
}

function recordOf(value: unknown, index: number, unit: number): CaptureRecord | undefined {
  if (typeof value !== 'object' || value === null) return undefined;
  const { time, side, direction, transport, from, to, bytes, hex, kind, verdict, known } = value as Readonly<
    Record<string, unknown>
  >;
  const digits = bytes ?? hex;
  const told = readKnown(known) ?? knownOf(kind, verdict);
  const read = typeof digits === 'string' && digits !== '' ? fromHex(digits) : undefined;
  const isWords = digits === '' && told?.text !== undefined;
  if (read === undefined && !isWords) return undefined;
  // What is heard while nobody has asked may be either.
  const said = side ?? (kind === 'heard' && verdict === undefined ? undefined : direction);
  const own = typeof said === 'string' ? SIDES[said] : undefined;
  return {
    bytes: read ?? new Uint8Array(0),
    transport: TRANSPORTS.find((one) => one === transport) ?? 'rtu',
    ...(typeof time === 'number' && Number.isFinite(time) && { time: time * unit }),
    ...(own && { side: own }),
    ...(typeof from === 'string' && { from }),
    ...(typeof to === 'string' && { to }),
    place: { kind: 'packet', numbers: [index + 1] },
    ...(told && { known: told }),
  };
}
