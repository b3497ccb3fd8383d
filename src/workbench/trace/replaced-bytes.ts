import { crc16, decodeFrame, hexDigits, lrc, type ProblemCode, type Reading } from '../../modbus/index.ts';
import type { CaptureRecord } from '../../trace/index.ts';

/** What is replaced in a trace that is given to somebody else. */
export interface Replaced {
  readonly units?: boolean;
  /** Addresses of registers, bits and records, and those of the network. */
  readonly addresses?: boolean;
  /** Times count from the first record. */
  readonly times?: boolean;
}

/** What stands for what is in a frame; `undefined` for what no undamaged frame has. */
export interface Stands {
  readonly replaced: Replaced;
  unit(unit: number, reading: Pick<Reading, 'transport'>): number | undefined;
  address(table: string, address: number): number | undefined;
  /** With the exception bit or without. */
  knowsFunction(functionCode: number): boolean;
}

type Framed = Pick<CaptureRecord, 'bytes' | 'transport' | 'side' | 'known'>;

/** A frame as it is read, and whether its bytes are what the reading says. */
interface SoundReading {
  readonly reading: Reading;
  /** The fields take all bytes. */
  readonly isSound: boolean;
  /** Its checksum does not hold. */
  readonly isDamaged: boolean;
}

/** With one of these, bytes may be others than they are read as. */
const BROKEN: ReadonlySet<ProblemCode> = new Set<ProblemCode>([
  'frame-extra',
  'pdu-short',
  'pdu-rest',
  'protocol-id-not-zero',
  'mbap-length-wrong',
  'ascii-character',
  'ascii-odd-digit',
  'ascii-end',
  'count-wrong',
  'count-contradicts-quantity',
  'count-odd',
]);
const EXCEPTION = 0x80;
const DIAGNOSTICS = 0x08;
const SERVER_ID = 0x11;
const READ_FILE = 0x14;
const WRITE_FILE = 0x15;
const RTU_CRC = 2;
const WRONG = 0xffff;
const ZERO = 0x30;
/** Digits and LRC of ASCII, and the line end. */
const DIGITS = /^:?((?:[0-9A-F]{2})+)(\r?\n?)$/i;

/** A frame as a frame of its side; or of the other, if it is one only there, such as an echo. */
export function soundReading({ bytes, transport, side = 'request', known }: Framed): SoundReading {
  const own = read(bytes, transport, side);
  if (known?.beside === 'noise') return { ...own, isSound: false };
  if (own.isSound) return own;
  const other = read(bytes, transport, side === 'request' ? 'response' : 'request');
  return other.isSound && !other.isDamaged ? other : own;
}

function read(bytes: Uint8Array, transport: Framed['transport'], direction: Reading['direction']): SoundReading {
  const reading = decodeFrame(bytes, { transport, direction });
  const { problems, outcome, checksum, open, spans } = reading;
  const isDamaged = problems.some(({ code }) => code === 'checksum-wrong');
  // Logs leave out the line end of ASCII frames.
  const isWhole =
    outcome.kind === 'whole' || (transport === 'ascii' && outcome.kind === 'short' && checksum !== undefined);
  const isSound =
    isWhole &&
    !(isDamaged && open) &&
    spans.every(({ kind }) => kind !== 'rest') &&
    problems.every(({ code }) => !BROKEN.has(code));
  return { reading, isSound, isDamaged };
}

/** An address in a frame: of which table, and where its two bytes begin. */
interface AddressPlace {
  readonly table: string;
  readonly address: number;
  readonly at: number;
  /** What the lowest of its table becomes. */
  readonly base: number;
}

/** The addresses in a sound frame, those of registers and bits, and the files and records of the functions for files. */
export function placesOf(
  { spans, fields, description, transport, direction, functionCode }: Reading,
  bytes: Uint8Array,
) {
  const places: AddressPlace[] = [];
  const wide = transport === 'ascii' ? 2 : 1;
  for (const { kind, name, from, to } of spans) {
    const address = fields[name];
    if (kind === 'address' && typeof address === 'number' && to - from === 2 * wide)
      places.push({ table: description?.table ?? '', address, at: from, base: 0 });
    const isFiles = functionCode === WRITE_FILE || (functionCode === READ_FILE && direction === 'request');
    if (kind !== 'groups' || !isFiles) continue;
    const word = (at: number) => numberAt(bytes, from + at * wide, 2, transport);
    for (let at = 0; from + (at + GROUP) * wide <= to; ) {
      const [file, record, length] = [word(at + 1), word(at + 3), word(at + 5)];
      places.push({ table: 'file', address: file, at: from + (at + 1) * wide, base: 1 });
      places.push({ table: `file ${file}`, address: record, at: from + (at + 3) * wide, base: 0 });
      at += GROUP + (functionCode === WRITE_FILE ? 2 * length : 0);
    }
  }
  return places;
}

/** The reference type, file, record and length of a group (AP 6.14). */
const GROUP = 7;

function numberAt(bytes: Uint8Array, at: number, width: number, transport: Reading['transport']): number {
  if (transport === 'ascii')
    return Number.parseInt(String.fromCharCode(...bytes.subarray(at, at + 2 * width)), 16) || 0;
  return bytes.subarray(at, at + width).reduce((sum, byte) => sum * 256 + byte, 0);
}

/** The bytes of a frame with what stands for its unit and its addresses. */
export function replacedBytes(record: Framed, stands: Stands): Uint8Array {
  const { reading, isSound: fits, isDamaged } = soundReading(record);
  const { functionCode } = reading;
  const knowsFunction = functionCode !== undefined && stands.knowsFunction(functionCode);
  // Any two bytes with the highest bit of the first look like an exception.
  const isSound = fits && (!isDamaged || knowsFunction || (functionCode ?? 0) < EXCEPTION);
  const { transport, unitId, spans, open } = reading;
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
  const isEnvelope = isSound || isAscii || (reading.protocolId === 0 && reading.length === record.bytes.length - 6);
  for (const { kind, from, to } of spans) {
    if (kind === 'unit') {
      if (to - from !== wide || unitId === undefined) blank(from, to);
      else if (units || !(isSound || stands.unit(unitId, reading) !== undefined))
        put(from, stands.unit(unitId, reading) ?? 0, 1);
    } else if (kind === 'function') {
      if (!isSound && !knowsFunction) blank(from, to);
    } else if (kind === 'envelope') {
      if (!isEnvelope) blank(from, to);
    } else if (!isSound || (kind === 'bytes' && open && functionCode !== DIAGNOSTICS)) blank(from, to);
    else if (kind === 'bytes' && functionCode === SERVER_ID && units && unitId !== undefined) {
      // Devices give their own number here.
      if (numberAt(record.bytes, from, 1, transport) === unitId) put(from, stands.unit(unitId, reading) ?? 0, 1);
    }
  }
  if (isSound && addresses) {
    for (const { table, address, at, base } of placesOf(reading, record.bytes)) {
      const stand = stands.address(table, address);
      put(at, stand === undefined ? 0 : stand + base, 2);
    }
  }
  if (transport === 'rtu') closeRtu(record.bytes, bytes, isSound && isDamaged);
  if (isAscii && isSound) closeAscii(record.bytes, bytes);
  return bytes;
}

/** Writes the CRC of changed bytes. A wrong one stays wrong: by the same bits, if it is that of `damaged` bytes. */
function closeRtu(before: Uint8Array, bytes: Uint8Array, damaged: boolean): void {
  const end = bytes.length - RTU_CRC;
  if (end < 1) return;
  const own = crc16(bytes, 0, end);
  const had = (before[end] ?? 0) | ((before[end + 1] ?? 0) << 8);
  const wrong = had ^ crc16(before, 0, end);
  const crc = own ^ (damaged ? wrong : wrong === 0 ? 0 : WRONG);
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
  const at = bytes[0] === COLON ? 1 : 0;
  bytes.set([digits.charCodeAt(0), digits.charCodeAt(1)], at + 2 * end);
}

const COLON = 0x3a;
