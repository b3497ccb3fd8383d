import { dictionary, fromHex, toHex } from '../modbus/index.ts';
import { type CaptureRecord, knownOf, readKnown, type TraceInput } from '../trace/index.ts';

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

/** Records as a file of JSON, which `readCapture` reads again, in parts; times are microseconds, and bytes digits, two each. */
export function* traceJsonParts(records: Iterable<TraceInput>): Generator<string, void, undefined> {
  let before = `{"format":"${FORMAT}","version":1,"records":[`;
  for (const { bytes, time, side, transport, from, to, known } of records) {
    yield `${before}\n${JSON.stringify({ time, side, transport, from, to, known, bytes: toHex(bytes) })}`;
    before = ',';
  }
  yield `${before === ',' ? '' : before}\n]}\n`;
}

/** Such a file in one piece. */
export const writeTraceJson = (records: Iterable<TraceInput>): string => [...traceJsonParts(records)].join('');

/** The records of such a file; `undefined` if the text is not one. What is not a record is left out. */
export function readTraceJson(text: string): readonly CaptureRecord[] | undefined {
  if (!/^\s*\{\s*"format"\s*:\s*"framewright (?:trace|log)"/.test(text)) return undefined;
  try {
    const { format, records, lines } = JSON.parse(text) as Readonly<Record<string, unknown>>;
    const [list, unit] = format === FORMAT ? [records, 1] : [format === OLD_FORMAT ? lines : undefined, MILLISECOND];
    if (!Array.isArray(list)) return undefined;
    return list.flatMap((one, index) => recordOf(one, index, unit) ?? []);
  } catch {
    return undefined;
  }
}

function recordOf(value: unknown, index: number, unit: number): CaptureRecord | undefined {
  if (typeof value !== 'object' || value === null) return undefined;
  const { time, side, direction, transport, from, to, bytes, hex, kind, verdict, known } = value as Readonly<
    Record<string, unknown>
  >;
  const digits = bytes ?? hex;
  const read = typeof digits === 'string' && digits !== '' ? fromHex(digits) : undefined;
  if (read === undefined) return undefined;
  // What is heard while nobody has asked may be either.
  const said = side ?? (kind === 'heard' && verdict === undefined ? undefined : direction);
  const told = readKnown(known) ?? knownOf(kind, verdict);
  const own = typeof said === 'string' ? SIDES[said] : undefined;
  return {
    bytes: read,
    transport: TRANSPORTS.find((one) => one === transport) ?? 'rtu',
    ...(typeof time === 'number' && Number.isFinite(time) && { time: time * unit }),
    ...(own && { side: own }),
    ...(typeof from === 'string' && { from }),
    ...(typeof to === 'string' && { to }),
    place: { kind: 'packet', numbers: [index + 1] },
    ...(told && { known: told }),
  };
}
