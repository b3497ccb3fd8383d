import { crc16, decodeFrame, hexDigits, lrc, type Reading } from '../../modbus/index.ts';
import { type CaptureRecord, Trace } from '../../trace/index.ts';

/** What is replaced in a trace that is given to somebody else. */
export interface Replaced {
  readonly units?: boolean;
  /** Addresses of registers and bits, and those of the network. */
  readonly addresses?: boolean;
  /** Times count from the first record. */
  readonly times?: boolean;
}

const RTU_CRC = 2;
const TCP_UNIT = 6;
/** LRC and line end of ASCII, from the end. */
const DIGITS = /^:((?:[0-9A-F]{2})+)(\r?\n?)$/i;

/**
 * A trace with other units, addresses and times: the same one always has the same stand-in. Units are numbered in the order in which they
 * speak, but a broadcast stays one; addresses of a table count from the lowest that is used; hosts become 192.0.2.1 and so on (RFC 5737).
 * Checksums are calculated again, and those that were wrong are as wrong as before.
 */
export function replacedTrace(trace: Trace, replaced: Replaced): Trace {
  const stand = new StandIns(trace, replaced);
  const made = new Trace({ timeout: trace.timeout / 1000 });
  for (let index = 0; index < trace.size; index++) made.add(stand.record(index));
  return made;
}

class StandIns {
  readonly #trace: Trace;
  readonly #replaced: Replaced;
  readonly #units = new Map<number, number>([[0, 0]]);
  readonly #hosts = new Map<string, string>();
  readonly #lowest = new Map<string, number>();

  constructor(trace: Trace, replaced: Replaced) {
    this.#trace = trace;
    this.#replaced = replaced;
    if (!replaced.addresses) return;
    for (let index = 0; index < trace.size; index++) {
      const reading = this.#reading(index);
      for (const [address] of addressesOf(reading)) {
        const table = tableOf(reading);
        this.#lowest.set(table, Math.min(address, this.#lowest.get(table) ?? address));
      }
    }
  }

  record(index: number): CaptureRecord {
    const record = this.#trace.plain(index);
    const { addresses, times } = this.#replaced;
    const { first = 0 } = this.#trace.span ?? {};
    return {
      ...record,
      bytes: this.#bytes(index),
      ...(times && record.time !== undefined && { time: record.time - first }),
      ...(addresses && { from: this.#host(record.from), to: this.#host(record.to) }),
    };
  }

  #reading(index: number): Reading {
    const { transport, side = 'request' } = this.#trace.spoken(index);
    return decodeFrame(this.#trace.bytes(index), { transport, direction: side });
  }

  #host(text: string | undefined): string | undefined {
    if (text === undefined) return undefined;
    const [, host = text, port = ''] = /^(.*)(:\d+)$/.exec(text) ?? [];
    let stand = this.#hosts.get(host);
    if (stand === undefined) {
      const number = this.#hosts.size + 1;
      stand = number < 255 ? `192.0.2.${number}` : `198.18.${number >> 8}.${number & 0xff}`;
      this.#hosts.set(host, stand);
    }
    return stand + port;
  }

  #unit(unit: number): number {
    let stand = this.#units.get(unit);
    if (stand === undefined) {
      stand = this.#units.size;
      this.#units.set(unit, stand);
    }
    return stand;
  }

  #bytes(index: number): Uint8Array {
    const reading = this.#reading(index);
    const { transport, unitId } = reading;
    const bytes = this.#trace.bytes(index).slice();
    const put = (at: number, value: number, width: number) => {
      const digits = hexDigits(value, 2 * width);
      for (let byte = 0; byte < width; byte++) {
        const pair = digits.slice(2 * byte, 2 * byte + 2);
        if (transport === 'ascii') bytes.set([pair.charCodeAt(0), pair.charCodeAt(1)], at + 2 * byte);
        else bytes[at + byte] = Number.parseInt(pair, 16);
      }
    };
    const unitAt = transport === 'tcp' ? TCP_UNIT : transport === 'ascii' ? 1 : 0;
    if (this.#replaced.units && unitId !== undefined) put(unitAt, this.#unit(unitId), 1);
    if (this.#replaced.addresses) {
      for (const [address, at] of addressesOf(reading)) put(at, address - (this.#lowest.get(tableOf(reading)) ?? 0), 2);
    }
    if (transport === 'rtu' || transport === 'ascii') closeAgain(this.#trace.bytes(index), bytes, transport);
    return bytes;
  }
}

const tableOf = ({ description }: Reading): string => description?.table ?? '';

/** The addresses in a frame that are all there, and where each stands. */
const addressesOf = ({ spans, fields }: Reading): readonly (readonly [address: number, at: number])[] =>
  spans.flatMap(({ kind, name, from, to }) => {
    const address = fields[name];
    return kind === 'address' && typeof address === 'number' && to > from ? [[address, from] as const] : [];
  });

/** Writes the checksum of changed bytes: it differs from the right one as that of the bytes before did. */
function closeAgain(before: Uint8Array, bytes: Uint8Array, transport: 'rtu' | 'ascii'): void {
  if (transport === 'rtu') {
    const end = bytes.length - RTU_CRC;
    if (end < 1) return;
    const wrong = crc16(before, 0, end) ^ crc16(bytes, 0, end);
    bytes[end] = (bytes[end] ?? 0) ^ (wrong & 0xff);
    bytes[end + 1] = (bytes[end + 1] ?? 0) ^ (wrong >> 8);
    return;
  }
  const [one, other] = [before, bytes].map((all) => DIGITS.exec(String.fromCharCode(...all))?.[1] ?? '');
  if (!one || !other || one.length < 4) return;
  const [was, is] = [one, other].map((text) =>
    Uint8Array.from(text.match(/../g) ?? [], (pair) => Number.parseInt(pair, 16)),
  );
  if (!was || !is) return;
  const end = is.length - 1;
  const sum = ((was[end] ?? 0) - lrc(was, 0, end) + lrc(is, 0, end)) & 0xff;
  const digits = hexDigits(sum, 2);
  bytes.set([digits.charCodeAt(0), digits.charCodeAt(1)], 1 + 2 * end);
}
