import type { EntityTable, NamedValue } from '../../devices/index.ts';
import { describeFunction } from '../../modbus/index.ts';
import { entityNumber } from '../../notation/index.ts';
import type { Beside, Outcome, Reason } from '../../trace/index.ts';
import {
  type RowAbout,
  type RowSaying,
  type RowValue,
  registerNumber,
  type SeenFault,
  type TraceRow,
} from '../../workbench/index.ts';
import { grouped, plural } from './common.ts';
import { devices } from './devices.ts';
import { exceptionName } from './sent.ts';

/** What went wrong with one frame. */
export const faults: Readonly<Record<SeenFault, string>> = {
  exception: 'exception',
  checksum: 'wrong CRC',
  'no-reply': 'no reply',
  late: 'late',
  doubtful: 'may answer the request before',
  mismatch: 'does not answer its request',
  broken: 'broken',
  stray: 'not asked for',
  timing: 'short silence',
  'no-frame': 'in no frame',
};

/** Why a piece of a text or a file is in no frame. */
const reasons: Readonly<Record<Reason, string>> = {
  'no-frame': 'in no frame',
  'not-a-byte': 'not a byte',
  'value-over-255': 'too large for a byte',
  'odd-digits': 'digits that do not make whole bytes',
  'not-of-base': 'not a number of the same base',
  'character-unknown': 'a character that is not a byte',
  'escape-unknown': 'an escape that is not known',
  'left-out': 'bytes are left out here',
};

/** What came beside the replies. */
const besides: Readonly<Record<Beside, string>> = {
  echo: 'echo of the request',
  late: 'late reply',
  copy: 'the same frame again',
  other: 'not asked for',
  noise: 'noise',
};

/** How a request went, where nothing more is to be said of its replies. */
const outcomes: Readonly<Partial<Record<Outcome, string>>> = {
  absent: 'no reply to a probe',
  ended: 'stopped before its reply',
};

/** What is to be said of a row beside what it says itself: what is wrong, and what the bus knows of it. */
export function remarks({ known, faults: found }: Pick<TraceRow, 'known' | 'faults'>): readonly string[] {
  if (known?.beside) return [known.why ? reasons[known.why] : besides[known.beside]];
  const outcome = known?.outcome && outcomes[known.outcome];
  return [
    ...found.map(({ kind, code }) =>
      kind === 'doubtful' && code === 'unsure' ? 'may answer another request' : faults[kind],
    ),
    ...(outcome ? [outcome] : []),
  ];
}

/** Bytes that are not a frame have no function. */
export const isFrame = ({ known }: Pick<TraceRow, 'known'>) => known?.beside !== 'noise';

/** What is in no frame, and where it stands: `3 bytes in line 12`, `“0G” in line 3`, `4 bytes from byte 1,024`. */
function piece({ known, place, length }: TraceRow): string {
  const what = known?.text === undefined ? plural(length, 'byte') : `“${known.text}”`;
  if (known?.line !== undefined) return `${what} in line ${grouped(known.line)}`;
  return place?.kind === 'bytes' ? `${what} from byte ${grouped(place.from)}` : what;
}

const MILLISECOND = 1000;
const SECOND = 1_000_000;

/** A length of time in microseconds: `210 µs`, `4.1 ms`, `1.5 s`. */
export function duration(time: number): string {
  if (time < MILLISECOND) return `${Math.round(time)} µs`;
  if (time < 10 * MILLISECOND) return `${(time / MILLISECOND).toFixed(1)} ms`;
  return time < 10 * SECOND ? `${grouped(Math.round(time / MILLISECOND))} ms` : `${(time / SECOND).toFixed(1)} s`;
}

const isNamed = (value: RowValue): value is NamedValue => 'register' in value;

/** `40108 = 555`, `P0681 = 4096 (30.0 Hz)`, `00001 = ON`. */
function valueText(value: RowValue, { table }: RowSaying): string {
  const isBit = table === 'coil' || table === 'discrete-input';
  const plain = (number: unknown) => (isBit ? (number ? 'ON' : 'OFF') : String(number));
  if (!isNamed(value)) return `${entityNumber(table, value.address)} = ${plain(value.value)}`;
  const means = devices.inUnits(value);
  const name = registerNumber(value.name);
  if (value.raw === undefined) return `${name} …`;
  return `${name} = ${plain(value.raw)}${means === '' ? '' : ` (${means})`}`;
}

/** `40108–40110`, `P0681–P0682`, or the values. */
function saying(said: RowSaying): string {
  const { table, first, count, names, values, more } = said;
  if (values.length > 0)
    return `${values.map((value) => valueText(value, said)).join(', ')}${more > 0 ? ` and ${grouped(more)} more` : ''}`;
  const place = (address: number, name: string | undefined) =>
    name === undefined ? entityNumber(table, address) : registerNumber(name);
  const from = place(first, names[0]);
  return count > 1 ? `${from}–${place(first + count - 1, names[1])}` : from;
}

/** What a row says: values, addresses, or how it was refused. */
export function means(row: TraceRow): string {
  const { exception, saying: said, reply } = row;
  if (!isFrame(row)) return piece(row);
  const own = said ? saying(said) : '';
  if (reply) return [own, means(reply)].filter(Boolean).join(' → ');
  return exception === undefined ? own : exceptionName(exception);
}

/** What a request does, by its access and its elements. */
function asks(row: TraceRow): string {
  const { saying: said, functionCode } = row;
  const { access, name } = describeFunction(functionCode, 'request');
  if (said === undefined) return name;
  const { table, first, count, values } = said;
  if (values.length > 0) return `${access === 'writes' ? 'Write ' : `${name}: `}${saying(said)}`;
  if (access !== 'reads') return `${name}: ${saying(said)}`;
  const elements = plural(count, kinds[table][0], kinds[table][1]);
  const own = said.names[0] === undefined ? '' : `, ${saying(said)}`;
  return `Read ${elements} from ${first} (${entityNumber(table, first)})${own}`;
}

const kinds: Readonly<Record<EntityTable, readonly [one: string, many: string]>> = {
  coil: ['coil', 'coils'],
  'discrete-input': ['discrete input', 'discrete inputs'],
  'input-register': ['input register', 'input registers'],
  'holding-register': ['holding register', 'holding registers'],
};

/** A row in words, as it stands in a report: what is asked or answered, and what is wrong with it. */
export function sentence(row: TraceRow): string {
  const { exception, side, saying: said, functionCode, reply } = row;
  const wrong = remarks({ known: row.known, faults: row.faults.filter(({ kind }) => kind !== 'exception') });
  if (!isFrame(row)) return [piece(row), ...wrong].join(', ');
  const answer = said && said.values.length > 0 ? saying(said) : describeFunction(functionCode, 'request').name;
  const refused = exception === undefined ? [] : [exceptionName(exception)];
  if (side !== 'response') {
    const answered = reply ? [sentence({ ...reply, faults: [] })] : refused;
    return [asks(row), ...answered, ...wrong].join(', ');
  }
  return [...(refused.length > 0 ? refused : [answer]), ...wrong].join(', ');
}

/** What is to be said of a chosen row beside its bytes; `undefined` if they say all. */
export function about({ row, silence }: RowAbout): string | undefined {
  if (!isFrame(row)) {
    const why = row.known?.why;
    return `In no frame: ${piece(row)}${why && why !== 'no-frame' ? `, ${reasons[why]}` : ''}.`;
  }
  if (silence === undefined || row.faults.every(({ kind }) => kind !== 'no-reply')) return undefined;
  const { timeout, next, after } = silence;
  if (next === undefined)
    return timeout === undefined
      ? 'No reply within the time-out.'
      : 'No reply: nothing follows this request in the log.';
  const came = sentence({ ...next, faults: [] });
  if (after === undefined) return `No reply. What comes next: ${came}.`;
  if (timeout === undefined) return `No reply within the time-out. ${duration(after)} later: ${came}.`;
  return after > timeout
    ? `No reply within ${duration(timeout)}. ${duration(after)} later: ${came}.`
    : `No reply before what comes ${duration(after)} later: ${came}.`;
}
