import { crc16, hexDigits, lrc, type Reading } from '../../modbus/index.ts';
import { traceOf } from '../../trace/index.ts';
import { agree, type Framed, placesOf, type SoundReading, soundReading } from './sound-frame.ts';

/** What is replaced in a trace that is given to somebody else. */
export interface Replaced {
  readonly units?: boolean;
  /** Addresses of registers, bits and records, and those of the network. */
  readonly addresses?: boolean;
  /** Times count from the first record. */
  readonly times?: boolean;
}

/** What stands for what is in a frame; `undefined` for what no intact frame has. */
export interface Stands {
  readonly replaced: Replaced;
  unit(unit: number, reading: Pick<Reading, 'transport'>): number | undefined;
  address(table: string, address: number): number | undefined;
}

/** What is known of a frame beside its bytes. */
export interface Beside {
  /** The frame that asks for it, or answers it. */
  readonly other: Framed | undefined;
  /** It is told as one whose checksum is wrong, and no more. */
  readonly isChecksum: boolean;
}

const DIAGNOSTICS = 0x08;
const SERVER_ID = 0x11;
/** A function that takes all bytes, and one that nothing has. */
const TAKES_ALL = 0x41;
const NO_FUNCTION = 0;
const EXCEPTION = 0x80;
const RTU_CRC = 2;
const MBAP_UNIT = 6;
const TRANSACTION = 2;
const WRONG = 0xffff;
const ZERO = 0x30;
/** The digits of ASCII with those of the LRC, and the line end. */
const LINE_END = /\r?\n?$/;
const DIGITS = /^:((?:[0-9A-F]{2})+)(\r?\n?)$/i;

/**
 * The bytes of a frame with what stands for its unit and its addresses. Of a damaged one that its request or its reply does not confirm,
 * nothing but the length and the kind of damage is kept: any of its bytes may be a unit or a part of an address, whatever it looks like.
 */
export function replacedBytes(record: Framed, stands: Stands, beside: Beside): Uint8Array {
  const sound = soundReading(record);
  const { fits, isIntact } = sound;
  const other = beside.other && soundReading(beside.other);
  const confirming = other?.fits && other.isIntact ? beside.other : undefined;
  if (isIntact) return told(record, sound, stands, () => true);
  if (fits && other && confirming && agree(record, confirming)) {
    const known = placesOf(other.reading, confirming.bytes);
    return told(record, sound, stands, (one) => known.some((place) => place.address === one));
  }
  return hidden(record, stands, confirming, beside.isChecksum);
}

/** A frame as it is read, with the addresses that are `sure`; where its fields do not fit, its head. */
function told(
  record: Framed,
  { reading, fits, isIntact }: SoundReading,
  stands: Stands,
  sure: (address: number) => boolean,
): Uint8Array {
  const { transport, unitId, spans, open, functionCode } = reading;
  const bytes = record.bytes.slice();
  const isAscii = transport === 'ascii';
  const wide = isAscii ? 2 : 1;
  const put = (at: number, value: number, width: number) => {
    const digits = hexDigits(value, 2 * width);
    for (let place = 0; place < width * wide; place++)
      bytes[at + place] = isAscii
        ? digits.charCodeAt(place)
        : Number.parseInt(digits.slice(2 * place, 2 * place + 2), 16);
  };
  const blank = (from: number, to: number) => bytes.fill(isAscii ? ZERO : 0, from, to);
  const { units, addresses } = stands.replaced;
  for (const { kind, from, to } of spans) {
    if (kind === 'envelope' || kind === 'function') continue;
    if (kind === 'unit') {
      if (units) put(from, stands.unit(unitId ?? 0, reading) ?? 0, 1);
    } else if (!fits || (kind === 'bytes' && open && functionCode !== DIAGNOSTICS)) blank(from, to);
    // Devices give their own number as the first byte.
    else if (kind === 'bytes' && functionCode === SERVER_ID && units) blank(from, Math.min(to, from + wide));
  }
  if (fits && addresses) {
    for (const { table, address, at, base } of placesOf(reading, record.bytes)) {
      const stand = sure(address) ? stands.address(table, address) : undefined;
      put(at, stand === undefined ? 0 : stand + base, 2);
    }
  }
  if (transport === 'rtu') closeRtu(bytes, isIntact ? 0 : wrongBits(record.bytes));
  if (isAscii) closeAscii(record.bytes, bytes);
  return bytes;
}

/** As many bytes that are damaged in the same way, and nothing of those of a record: what is told of them is that of the other frame. */
function hidden(record: Framed, stands: Stands, other: Framed | undefined, isChecksum: boolean): Uint8Array {
  const { transport, side } = record;
  const { unitId, functionCode } = other ? soundReading(other).reading : {};
  const unit = (stands.replaced.units ? stands.unit(unitId ?? 0, { transport }) : unitId) ?? 0;
  const known = functionCode === undefined ? [] : [functionCode & ~EXCEPTION];
  let bytes: Uint8Array = record.bytes;
  for (const code of [...known, isChecksum ? TAKES_ALL : NO_FUNCTION]) {
    bytes = blanked(record, [unit, code], other);
    const [fault] = traceOf([{ bytes, transport, side }]).faults(0);
    if ((fault?.kind === 'checksum') === isChecksum) break;
  }
  return bytes;
}

/** Zeros that begin with some bytes and have a wrong checksum, and what belongs together is known by on TCP. */
function blanked({ bytes, transport }: Framed, head: readonly number[], other: Framed | undefined): Uint8Array {
  if (transport === 'ascii') return blankedAscii(bytes, head);
  const made = new Uint8Array(bytes.length);
  const put = (first: number, values: Iterable<number>) => {
    let at = first;
    for (const value of values) made[at++] = value;
  };
  put(transport === 'tcp' ? MBAP_UNIT : 0, head);
  if (transport === 'tcp') put(0, other?.bytes.subarray(0, TRANSACTION) ?? []);
  else closeRtu(made, WRONG);
  return made;
}

function blankedAscii(bytes: Uint8Array, head: readonly number[]): Uint8Array {
  const made = new Uint8Array(bytes.length).fill(ZERO);
  const first = bytes[0] === COLON ? 1 : 0;
  const ending = LINE_END.exec(String.fromCharCode(...bytes.subarray(first)))?.[0].length ?? 0;
  made.set(bytes.subarray(0, first));
  made.set(bytes.subarray(bytes.length - ending), bytes.length - ending);
  const digits = made.subarray(first, bytes.length - ending);
  const put = (at: number, byte: number) => {
    [...hexDigits(byte, 2)].forEach((digit, into) => {
      digits[at + into] = digit.charCodeAt(0);
    });
  };
  head.forEach((byte, at) => void put(2 * at, byte));
  if (digits.length >= 2 * head.length + 2) put(digits.length - 2, (lrc(Uint8Array.from(head)) + 1) & 0xff);
  return made;
}

/** The bits by which the CRC of a frame is wrong. */
function wrongBits(bytes: Uint8Array): number {
  const end = bytes.length - RTU_CRC;
  return ((bytes[end] ?? 0) | ((bytes[end + 1] ?? 0) << 8)) ^ crc16(bytes, 0, end);
}

/** Writes the CRC of changed bytes, with some bits wrong. Too few have none. */
function closeRtu(bytes: Uint8Array, wrong: number): void {
  const end = bytes.length - RTU_CRC;
  if (end < 2) return;
  const crc = crc16(bytes, 0, end) ^ wrong;
  bytes[end] = crc & 0xff;
  bytes[end + 1] = crc >> 8;
}

/** Writes the LRC of changed digits: it differs from the right one as that of the digits before did. */
function closeAscii(before: Uint8Array, bytes: Uint8Array): void {
  const pairs = (all: Uint8Array) => {
    const [, digits = ''] = DIGITS.exec(String.fromCharCode(...all)) ?? [];
    return Uint8Array.from(digits.match(/../g) ?? [], (pair) => Number.parseInt(pair, 16));
  };
  const [was, is] = [pairs(before), pairs(bytes)];
  const end = is.length - 1;
  if (end < 1) return;
  const sum = ((was[end] ?? 0) - lrc(was, 0, end) + lrc(is, 0, end)) & 0xff;
  const digits = hexDigits(sum, 2);
  bytes.set([digits.charCodeAt(0), digits.charCodeAt(1)], 1 + 2 * end);
}

const COLON = 0x3a;
