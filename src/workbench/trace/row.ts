import { type EntityTable, type NamedValue, nameAt, namedValues, type Profile } from '../../devices/index.ts';
import { decodeFrame, type Reading, toHex } from '../../modbus/index.ts';
import {
  type CaptureRecord,
  type Fault,
  type Known,
  type Place,
  type Trace,
  type ValueList,
  valuesRead,
  valuesWritten,
} from '../../trace/index.ts';
import { type SeenFault, seenFault } from './seen-fault.ts';

/** A fault of a row, or of its exchange; `code` says more exactly what it is. */
export interface TraceFault {
  readonly kind: SeenFault;
  readonly code: string;
}

/** A register (0 to 65535) or a bit (0 or 1), to which the device has no name. */
interface PlainValue {
  readonly address: number;
  readonly value: number;
}

export type RowValue = PlainValue | NamedValue;

/** What a frame says: the elements that it is about, and their values. */
export interface RowSaying {
  readonly table: EntityTable;
  /** As sent, counted from 0. */
  readonly first: number;
  readonly count: number;
  /** What the device calls the first and the last of them. */
  readonly names: readonly [first: string | undefined, last: string | undefined];
  /** Some of the values, from the first on; empty in a request that reads. */
  readonly values: readonly RowValue[];
  /** How many values follow them. */
  readonly more: number;
}

/** A frame of a trace, or a piece in no frame, as a row of a list shows it: plain data. Times are microseconds. */
export interface TraceRow {
  /** Of the record, counted from 0. */
  readonly index: number;
  readonly exchange: number;
  /** Since 1970, or since the first record where the source knows no date. */
  readonly time: number | undefined;
  /** Since the first record. */
  readonly since: number | undefined;
  /** Since the record before. */
  readonly gap: number | undefined;
  readonly side: CaptureRecord['side'];
  readonly transport: CaptureRecord['transport'];
  /** NaN, like the function, of a piece in no frame. */
  readonly unit: number;
  /** Without the exception bit. */
  readonly functionCode: number;
  readonly exception: number | undefined;
  /** From the request, of a reply. */
  readonly after: number | undefined;
  readonly faults: readonly TraceFault[];
  /** What its source knows of it. */
  readonly known?: Known | undefined;
  /** Where a piece in no frame stands. */
  readonly place?: Place | undefined;
  /** The first bytes, two digits each, and how many there are in all. */
  readonly hex: string;
  readonly length: number;
  readonly saying: RowSaying | undefined;
  /** In a list of exchanges: the first reply. */
  readonly reply?: TraceRow | undefined;
}

/** The top bit of a function code, which says that a reply is an exception (AP 7). */
const EXCEPTION_BIT = 0x80;
/** Bytes that a row has of a frame. */
export const SHOWN = 64;
/** Values that a row has. */
const MOST_VALUES = 8;

/** The row of a record; names are those of the device. */
export function rowOf(trace: Trace, index: number, profile: Profile | undefined): TraceRow {
  const exchange = trace.exchangeOf(index);
  const faults = trace.faults(exchange);
  const known = trace.known(index);
  const time = trace.time(index);
  const origin = trace.span?.first;
  const before = timeBefore(trace, index);
  const bytes = trace.bytes(index);
  const own = faults.length === 0 ? faults : faults.filter(({ records }) => records.at(-1) === index);
  const isFrame = trace.isFrame(index);
  const readings = isFrame ? readingsOf(trace, index) : undefined;
  const { unit, functionCode } = trace.subject(exchange);
  return {
    index,
    exchange,
    time,
    since: time === undefined || origin === undefined ? undefined : time - origin,
    gap: time === undefined || before === undefined ? undefined : time - before,
    side: trace.side(index),
    transport: trace.transport(index),
    unit,
    functionCode: (readings && ownFunction(readings)) ?? functionCode,
    exception: readings && exceptionOf(readings),
    after: trace.replyOf(exchange) === index ? trace.after(exchange) : undefined,
    faults: own.map(faultOf),
    ...(known && { known }),
    ...(!isFrame && { place: trace.plain(index).place }),
    hex: toHex(bytes.subarray(0, SHOWN)),
    length: bytes.length,
    saying: readings && sayingOf(trace, index, readings, profile),
  };
}

const faultOf = (fault: Fault): TraceFault => ({ kind: seenFault(fault), code: fault.code });

/** When the record before was made: a piece in no frame may have no time. */
function timeBefore(trace: Trace, index: number): number | undefined {
  for (let at = index - 1; at >= 0; at--) {
    const time = trace.time(at);
    if (time !== undefined || trace.isFrame(at)) return time;
  }
  return undefined;
}

/** The function that a frame says itself: if it is damaged, not always that of its exchange. `undefined` if it is too short. */
const ownFunction = ({ reading: { functionCode }, isReply }: Readings): number | undefined =>
  functionCode === undefined || !isReply ? functionCode : functionCode & ~EXCEPTION_BIT;

/** The code of the exception that a reply says, also one without a sound checksum. */
function exceptionOf({ reading: { functionCode = 0, fields }, isReply }: Readings): number | undefined {
  const { exceptionCode } = fields;
  return isReply && functionCode >= EXCEPTION_BIT && typeof exceptionCode === 'number' ? exceptionCode : undefined;
}

/** The row of an exchange: that of its request, or of the reply that nobody asked for, with the first reply and all faults. */
export function exchangeRowOf(trace: Trace, exchange: number, profile: Profile | undefined): TraceRow {
  const [request, first] = [trace.requestOf(exchange), trace.replyOf(exchange)];
  const row = rowOf(trace, request ?? first ?? 0, profile);
  const reply = request === undefined || first === undefined ? undefined : rowOf(trace, first, profile);
  return {
    ...row,
    after: trace.after(exchange),
    exception: row.exception ?? reply?.exception,
    faults: trace.faults(exchange).map(faultOf),
    reply,
  };
}

/** The values of a record's frame, those that it writes or those that it shows; `undefined` if it has none. */
export function valuesIn(trace: Trace, index: number): ValueList | undefined {
  const { requested, reading, isReply } = readingsOf(trace, index);
  return isReply ? requested && valuesRead(requested, reading) : valuesWritten(reading);
}

interface Readings {
  readonly requested: Reading | undefined;
  readonly reading: Reading;
  readonly isReply: boolean;
}

function readingsOf(trace: Trace, index: number): Readings {
  const transport = trace.transport(index);
  const request = trace.requestOf(trace.exchangeOf(index));
  const isReply = trace.side(index) === 'response';
  const asked = request === undefined ? undefined : trace.bytes(request);
  const reading = decodeFrame(trace.bytes(index), {
    transport,
    direction: isReply ? 'response' : 'request',
    request: isReply ? asked : undefined,
  });
  const isAsked = request === index && !isReply;
  const requested = isAsked ? reading : asked && decodeFrame(asked, { transport, direction: 'request' });
  return { requested, reading, isReply };
}

function sayingOf(
  trace: Trace,
  index: number,
  { requested, reading, isReply }: Readings,
  profile: Profile | undefined,
): RowSaying | undefined {
  // A damaged reply with another function shows nothing of what was asked.
  if (isReply && requested !== undefined && ownFunction({ requested, reading, isReply }) !== requested.functionCode)
    return undefined;
  const table = (requested ?? reading).description?.table;
  if (table === undefined || table === 'file-record') return undefined;
  const { address, quantity } = trace.subject(trace.exchangeOf(index));
  const found = isReply ? requested && valuesRead(requested, reading) : valuesWritten(reading);
  const first = found?.first ?? address;
  if (first === undefined) return undefined;
  const count = found?.values.length ?? quantity;
  const name = (at: number) => profile && nameAt(profile, table, at);
  const values = found ? valuesFrom(found.first, found.values, table, profile) : [];
  return {
    table,
    first,
    count,
    names: [name(first), count > 1 ? name(first + count - 1) : undefined],
    values: values.slice(0, MOST_VALUES),
    more: Math.max(0, values.length - MOST_VALUES),
  };
}

/** The values of a list: by their names, where the device has some, and the others by their addresses. */
function valuesFrom(
  first: number,
  list: readonly number[],
  table: EntityTable,
  profile: Profile | undefined,
): readonly RowValue[] {
  const named = profile ? namedValues(profile, table, first, list) : [];
  if (named.length === 0) return list.map((value, at) => ({ address: first + at, value }));
  const taken = new Set(named.flatMap(({ at, size }) => Array.from({ length: size }, (_, into) => at + into)));
  const plain = list.flatMap((value, at) => (taken.has(at) ? [] : [{ address: first + at, value }]));
  return [...named, ...plain].sort((one, other) => one.address - other.address);
}
