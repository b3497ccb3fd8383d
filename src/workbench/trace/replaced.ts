import type { Reading } from '../../modbus/index.ts';
import { type CaptureRecord, Trace } from '../../trace/index.ts';
import { type Beside, type Replaced, replacedBytes, type Stands } from './replaced-bytes.ts';
import { placesOf, soundReading } from './sound-frame.ts';

/** A trace with other units, addresses and times, all of it at once: see `StandIns`. */
export function replacedTrace(trace: Trace, replaced: Replaced): Trace {
  const stand = new StandIns(trace, replaced);
  stand.learn(trace.size);
  const made = new Trace({ timeout: trace.timeout / 1000 });
  for (let index = 0; index < trace.size; index++) made.add(stand.record(index));
  return made;
}

const MODBUS_PORT = 502;
const FIRST_PORT = 49_152;
const PORTS = 16_384;
/** Unit 0 is a broadcast on a serial line, and a unit like others on TCP. */
const ZERO_ON_TCP = 256;
const MOST_UNIT = 255;

/**
 * What stands for units, addresses and times; the same one always has the same stand-in. Units are numbered in the order in which they
 * speak, but a broadcast stays one; addresses of a table count from the lowest that is used; hosts become 192.0.2.1 and so on (RFC 5737);
 * times count from the first. Nothing that is written depends on the real ones in any other way. What is damaged, so that any of its bytes
 * may be any of these, becomes 0. Checksums are calculated again, and those that were wrong are wrong.
 */
export class StandIns implements Stands {
  readonly #trace: Trace;
  readonly replaced: Replaced;
  /** How many records there were when it began: later ones are not looked at. */
  readonly size: number;
  readonly #units = new Map<number, number>([[0, 0]]);
  readonly #ends = new Map<string, string>();
  readonly #hosts = new Map<string, string>();
  readonly #serverPorts = new Map<string, number>();
  readonly #lowest = new Map<string, number>();
  readonly #addresses = new Set<string>();
  #learned = 0;

  constructor(trace: Trace, replaced: Replaced) {
    this.#trace = trace;
    this.replaced = replaced;
    this.size = trace.size;
  }

  /** Looks at so many more records; true once it has seen all: before that, `record` is not to be asked. */
  learn(most: number): boolean {
    const { units, addresses } = this.replaced;
    const end = units || addresses ? Math.min(this.size, this.#learned + most) : this.size;
    if (units || addresses) for (let index = this.#learned; index < end; index++) this.#learn(index);
    this.#learned = end;
    return end === this.size;
  }

  /** Which part of the records it has seen, from 0 to 1. */
  get learned(): number {
    return this.size === 0 ? 1 : this.#learned / this.size;
  }

  record(index: number): CaptureRecord {
    const record = this.#trace.plain(index);
    const { units, addresses, times } = this.replaced;
    const { first = 0 } = this.#trace.span ?? {};
    return {
      ...record,
      ...(record.known?.beside === 'noise' && { known: { beside: 'noise' } as const }),
      ...((units || addresses) && { bytes: replacedBytes(record, this, this.#beside(index)) }),
      ...(times && record.time !== undefined && { time: record.time - first }),
      ...(addresses && { from: this.#end(record, 'from'), to: this.#end(record, 'to') }),
    };
  }

  unit(unit: number, { transport }: Pick<Reading, 'transport'>): number | undefined {
    return this.#units.get(keyOf(unit, transport));
  }

  address(table: string, address: number): number | undefined {
    return this.#addresses.has(`${table} ${address}`) ? address - (this.#lowest.get(table) ?? 0) : undefined;
  }

  #learn(index: number): void {
    const record = this.#trace.plain(index);
    if (this.replaced.addresses) {
      this.#end(record, 'from');
      this.#end(record, 'to');
    }
    const { reading, fits, isIntact } = soundReading(record);
    if (!isIntact) return;
    const { unitId, transport } = reading;
    this.#number(unitId === undefined ? 0 : keyOf(unitId, transport));
    for (const { table, address } of fits ? placesOf(reading, record.bytes) : []) {
      this.#addresses.add(`${table} ${address}`);
      this.#lowest.set(table, Math.min(address, this.#lowest.get(table) ?? address));
    }
  }

  #beside(index: number): Beside {
    const exchange = this.#trace.exchangeOf(index);
    const [{ request, replies, faults } = { request: undefined, replies: [], faults: [] }] = this.#trace.exchanges(
      exchange,
      exchange + 1,
    );
    const other = index === request ? replies[0] : request;
    return {
      other: other === undefined ? undefined : this.#trace.plain(other),
      isChecksum: faults.some(({ kind, records }) => kind === 'checksum' && records.at(-1) === index),
    };
  }

  #number(unit: number): void {
    if (!this.#units.has(unit)) this.#units.set(unit, Math.min(this.#units.size, MOST_UNIT));
  }

  /** What stands for an end of a connection. A server has port 502, as far as its host has one server. */
  #end(record: CaptureRecord, end: 'from' | 'to'): string | undefined {
    const text = record[end];
    if (text === undefined) return undefined;
    const known = this.#ends.get(text);
    if (known !== undefined) return known;
    const [, host, port] = /^(\[.*\]|[^:]*):(\d+)$/.exec(text) ?? [];
    const isServer = record.side === (end === 'to' ? 'request' : 'response');
    const stand =
      host === undefined || port === undefined
        ? `end ${this.#ends.size + 1}`
        : `${this.#host(host)}:${isServer ? this.#serverPort(host) : FIRST_PORT + (this.#ends.size % PORTS)}`;
    this.#ends.set(text, stand);
    return stand;
  }

  #host(host: string): string {
    let stand = this.#hosts.get(host);
    if (stand === undefined) {
      const number = this.#hosts.size + 1;
      stand = number < 255 ? `192.0.2.${number}` : `198.18.${(number >> 8) & 0xff}.${number & 0xff}`;
      this.#hosts.set(host, stand);
    }
    return stand;
  }

  #serverPort(host: string): number {
    const port = this.#serverPorts.get(host) ?? MODBUS_PORT;
    this.#serverPorts.set(host, port + 1);
    return port;
  }
}

const keyOf = (unit: number, transport: Reading['transport']) =>
  unit === 0 && transport === 'tcp' ? ZERO_ON_TCP : unit;
