import { crc16, decodeFrame, isAgainstRequest, type ProblemCode, type Reading } from '../../modbus/index.ts';
import type { CaptureRecord } from '../../trace/index.ts';

export type Framed = Pick<CaptureRecord, 'bytes' | 'transport' | 'side' | 'known'>;

/** A frame as it is read, and how far its bytes are what the reading says. */
export interface SoundReading {
  readonly reading: Reading;
  /** Its fields take all bytes, whatever its checksum. */
  readonly fits: boolean;
  /** It came as it was sent, by its checksum or its MBAP, so that its unit and its function are what they seem. */
  readonly isIntact: boolean;
}

/** With one of these, bytes may be others than they are read as. */
const BROKEN: ReadonlySet<ProblemCode> = new Set<ProblemCode>([
  'frame-extra',
  'pdu-short',
  'pdu-rest',
  'protocol-id-not-zero',
  'mbap-length-wrong',
  'ascii-start',
  'ascii-character',
  'ascii-odd-digit',
  'ascii-end',
  'count-wrong',
  'count-contradicts-quantity',
  'count-odd',
]);
const READ_FILE = 0x14;
const WRITE_FILE = 0x15;
/** Unit, function and CRC. */
const LEAST_RTU = 4;
/** MBAP and function. */
const LEAST_TCP = 8;
const BEFORE_LENGTH = 6;

/** A frame as a frame of its side; or of the other, if it is a good one only there, such as an echo. */
export function soundReading({ bytes, transport, side = 'request', known }: Framed): SoundReading {
  const own = read(bytes, transport, side);
  if (known?.beside === 'noise') return { ...own, fits: false, isIntact: false };
  if (own.fits) return own;
  const other = read(bytes, transport, side === 'request' ? 'response' : 'request');
  const isGood = other.reading.problems.every(({ severity, code }) => severity !== 'error' || code === 'frame-short');
  return other.fits && other.isIntact && isGood ? other : own;
}

function read(bytes: Uint8Array, transport: Framed['transport'], direction: Reading['direction']): SoundReading {
  const reading = decodeFrame(bytes, { transport, direction });
  const { problems, outcome, checksum, open, spans } = reading;
  const holds = problems.every(({ code }) => code !== 'checksum-wrong');
  // Logs leave out the line end of ASCII frames.
  const isWhole =
    outcome.kind === 'whole' || (transport === 'ascii' && outcome.kind === 'short' && checksum !== undefined);
  const fits =
    isWhole &&
    (holds || !open) &&
    spans.every(({ kind }) => kind !== 'rest') &&
    problems.every(({ code }) => !BROKEN.has(code));
  return { reading, fits, isIntact: isIntact(reading, bytes, fits && holds) };
}

/** An LRC holds too easily to prove anything alone. */
function isIntact({ transport, protocolId, length }: Reading, bytes: Uint8Array, isSound: boolean): boolean {
  if (transport === 'ascii') return isSound;
  if (transport === 'rtu') return bytes.length >= LEAST_RTU && crc16(bytes) === 0;
  return bytes.length >= LEAST_TCP && protocolId === 0 && length === bytes.length - BEFORE_LENGTH;
}

/** Whether one is the reply that the other asks for, so that only chance could make damaged bytes of either look like that. */
export function agree({ bytes, transport, side }: Framed, other: Framed): boolean {
  if (transport !== other.transport || side === other.side) return false;
  const [request, reply] = side === 'response' ? [other.bytes, bytes] : [bytes, other.bytes];
  return !isAgainstRequest(decodeFrame(reply, { transport, direction: 'response', request }));
}

/** An address in a frame: of which table, and where its two bytes begin. */
interface AddressPlace {
  readonly table: string;
  readonly address: number;
  readonly at: number;
  /** What the lowest of its table becomes. */
  readonly base: number;
}

/** The addresses in a frame whose fields fit, those of registers and bits, and the files and records of the functions for files. */
export function placesOf(
  { spans, fields, description, transport, direction, functionCode }: Reading,
  bytes: Uint8Array,
): readonly AddressPlace[] {
  const places: AddressPlace[] = [];
  const wide = transport === 'ascii' ? 2 : 1;
  for (const { kind, name, from, to } of spans) {
    const address = fields[name];
    if (kind === 'address' && typeof address === 'number' && to - from === 2 * wide)
      places.push({ table: description?.table ?? '', address, at: from, base: 0 });
    const isFiles = functionCode === WRITE_FILE || (functionCode === READ_FILE && direction === 'request');
    if (kind !== 'groups' || !isFiles) continue;
    const word = (at: number) => wordAt(bytes, from + at * wide, transport);
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
const WORD = 2;

function wordAt(bytes: Uint8Array, at: number, transport: Reading['transport']): number {
  if (transport === 'ascii') return Number.parseInt(String.fromCharCode(...bytes.subarray(at, at + 2 * WORD)), 16) || 0;
  return ((bytes[at] ?? 0) << 8) | (bytes[at + 1] ?? 0);
}
