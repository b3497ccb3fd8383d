import { decodeFrame, type Reading, type Table } from '../modbus/index.ts';
import type { Trace } from './trace.ts';

export type KnownTable = Exclude<Table, 'file-record'>;

/** What a trace shows of one register, or of one bit. */
export interface KnownValue {
  readonly unit: number;
  readonly table: KnownTable;
  /** As sent, counted from 0. */
  readonly address: number;
  /** 0 to 65535, or 0 or 1. */
  value: number;
  /** When it had this value last, in microseconds; `undefined` if the records have no times. */
  time: number | undefined;
  /** The record that showed it last. */
  record: number;
  reads: number;
  writes: number;
  /** How often it was another than the time before. */
  changes: number;
}

const TABLES: readonly KnownTable[] = ['coil', 'discrete-input', 'input-register', 'holding-register'];
const ADDRESSES = 65_536;

/** The registers and bits of each unit, as they became known. A trace that has grown is gone on with. */
export class KnownValues {
  readonly #trace: Trace;
  readonly #known = new Map<number, KnownValue>();
  #next = 0;

  constructor(trace: Trace) {
    this.#trace = trace;
  }

  /** How many exchanges have been looked at. */
  get taken(): number {
    return this.#next;
  }

  /** Takes the exchanges that are settled, `most` at a time; the last `open` of them are left for later. */
  take(open = 0, most = Number.POSITIVE_INFINITY): this {
    const end = Math.min(this.#trace.exchangeCount - open, this.#next + most);
    for (; this.#next < end; this.#next++) this.#learn(this.#next);
    return this;
  }

  /** Only a reply that answers its request, without a fault of its own, shows anything. */
  #learn(index: number): void {
    const [exchange] = this.#trace.exchanges(index, index + 1);
    const [reply] = exchange?.replies ?? [];
    if (exchange?.request === undefined || reply === undefined) return;
    if (exchange.faults.some(({ kind }) => kind !== 'late' && kind !== 'timing' && kind !== 'stray')) return;
    const asked = this.#trace.bytes(exchange.request);
    const { transport, time } = this.#trace.spoken(reply);
    const request = decodeFrame(asked, { transport, direction: 'request' });
    const response = decodeFrame(this.#trace.bytes(reply), { transport, direction: 'response', request: asked });
    const { description } = request;
    const table = description?.table;
    if (description === undefined || table === undefined || table === 'file-record' || request.unitId === undefined)
      return;
    const seen = { unit: request.unitId, table, record: reply, time };
    const see = (list: ValueList | undefined, isWrite: boolean) =>
      list?.values.forEach((value, at) => {
        this.#see({ ...seen, address: list.first + at, value }, isWrite);
      });
    see(valuesWritten(request), true);
    see(valuesRead(request, response), false);
  }

  #see(seen: Pick<KnownValue, 'unit' | 'table' | 'address' | 'value' | 'time' | 'record'>, isWrite: boolean): void {
    const { unit, table, address, value, time, record } = seen;
    if (address >= ADDRESSES) return;
    const key = (unit * TABLES.length + TABLES.indexOf(table)) * ADDRESSES + address;
    const known = this.#known.get(key);
    const [reads, writes] = isWrite ? [0, 1] : [1, 0];
    if (known === undefined) {
      this.#known.set(key, { ...seen, reads, writes, changes: 0 });
      return;
    }
    known.reads += reads;
    known.writes += writes;
    if (known.value !== value) known.changes++;
    known.value = value;
    known.time = time;
    known.record = record;
  }

  /** All of them, by unit, table and address. */
  get list(): readonly KnownValue[] {
    return [...this.#known].sort(([one], [other]) => one - other).map(([, known]) => known);
  }
}

/** Registers (0 to 65535) or bits (0 or 1) in a frame, and the address of the first. */
export interface ValueList {
  readonly first: number;
  readonly values: readonly number[];
}

const addressesIn = ({ spans, fields }: Reading): readonly unknown[] =>
  spans.filter(({ kind }) => kind === 'address').map(({ name }) => fields[name]);

/** What a request writes; `undefined` if it writes no registers or bits. */
export function valuesWritten(request: Reading): ValueList | undefined {
  const access = request.description?.access;
  const addresses = addressesIn(request);
  const first = addresses[access === 'reads-and-writes' ? 1 : 0];
  const values = access === 'reads' ? undefined : listIn(request);
  return values && typeof first === 'number' ? { first, values } : undefined;
}

/** What a reply shows of what its request reads; `undefined` if that is no registers or bits. */
export function valuesRead(request: Reading, response: Reading): ValueList | undefined {
  const [first] = addressesIn(request);
  const values = request.description?.access === 'writes' ? undefined : listIn(response);
  if (values === undefined || typeof first !== 'number') return undefined;
  // The bits behind those that were asked for are padding.
  const quantity = request.spans.find(({ kind }) => kind === 'quantity');
  const asked = quantity && request.fields[quantity.name];
  return { first, values: typeof asked === 'number' ? values.slice(0, asked) : values };
}

/** The registers or bits of a frame, or the one value that it sets. */
function listIn({ fields, spans, problems }: Reading): readonly number[] | undefined {
  if (problems.some(({ severity }) => severity === 'error')) return undefined;
  const list = spans.find(({ kind }) => kind === 'registers' || kind === 'bits');
  const values = list && fields[list.name];
  if (Array.isArray(values)) return values.map(Number);
  const one = spans.find(({ kind, name }) => kind === 'flag' || name === 'value');
  const value = one && fields[one.name];
  return typeof value === 'number' || typeof value === 'boolean' ? [Number(value)] : undefined;
}
