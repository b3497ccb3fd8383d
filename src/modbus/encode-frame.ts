import type { Force, Values } from './field.ts';
import { wholeNumber } from './fields/number.ts';
import { Output } from './output.ts';
import { writePdu } from './pdu.ts';
import type { Direction, Transport } from './reading.ts';
import { type Checksum, CRC, LRC } from './serial.ts';

/** A frame as a person says it. */
export interface FrameInput {
  readonly transport: Transport;
  readonly direction: Direction;
  /** 0…255; not needed for a bare PDU. */
  readonly unitId?: number | undefined;
  /** TCP: 0…65535, by default 0. */
  readonly transactionId?: number | undefined;
  /** 0…255; a reply with the exception bit set (80 and above) carries the field `exceptionCode`. */
  readonly functionCode?: number | undefined;
  /** The function's fields by name. Names that the encoder derives, and names it does not know, are ignored. */
  readonly fields: Values;
  /**
   * Values that replace derived ones: a number, or hexadecimal pairs for bytes verbatim (`''` for no bytes). `checksum` as
   * a number is the CRC register or the LRC. `rest` adds bytes to the PDU, `after` adds bytes after the frame; `padding` and
   * `rawValue` set the unused bits of a bit field and the raw value of a coil; `start`, `characters` and `end` replace those
   * parts of an ASCII frame.
   */
  readonly force?: Force | undefined;
}

/** One buffer for all frames; the next frame overwrites what is left of one that could not be encoded. */
const shared = new Output();

/**
 * The bytes of a frame (AP 4.1; SL 2.5; TG 3.1.3). Throws a `FrameError` for what has no bytes, such as 70000 in 16 bits;
 * what has bytes but breaks a rule is encoded, and reported when it is decoded.
 */
export function encodeFrame(input: FrameInput): Uint8Array {
  const out = shared;
  out.length = 0;
  switch (input.transport) {
    case 'rtu':
      writeSerial(out, input, CRC);
      break;
    case 'ascii':
      return encodeAscii(out, input);
    case 'tcp':
      writeTcp(out, input);
      break;
    case 'pdu':
      writePdu(out, input.functionCode, input.direction, input.fields, input.force);
      break;
    default:
      throw new TypeError(`transport: ${String(input.transport)} is not rtu, ascii, tcp or pdu`);
  }
  if (input.force?.['after'] !== undefined) out.pairs(input.force['after'], 'after');
  return out.take();
}

/** Writes a number of the envelope, or the bytes it is forced to. */
function writeNumber(out: Output, width: 1 | 2, value: unknown, name: string, force: Force | undefined): void {
  const forced = force?.[name];
  if (typeof forced === 'string') out.pairs(forced, name);
  else if (width === 1) out.u8(wholeNumber(forced ?? value, name, 0, 0xff));
  else out.u16(wholeNumber(forced ?? value, name, 0, 0xffff));
}

function writeSerial(
  out: Output,
  { unitId, functionCode, direction, fields, force }: FrameInput,
  checksum: Checksum,
): void {
  writeNumber(out, 1, unitId, 'unitId', force);
  writePdu(out, functionCode, direction, fields, force);
  const { width } = checksum;
  const forced = force?.['checksum'];
  if (typeof forced === 'string') {
    out.pairs(forced, 'checksum');
  } else {
    const most = width === 1 ? 0xff : 0xffff;
    const value =
      forced === undefined ? checksum.compute(out.bytes, 0, out.length) : wholeNumber(forced, 'checksum', 0, most);
    const at = out.grow(width);
    checksum.write(out.bytes, at, value);
  }
}

function writeTcp(out: Output, input: FrameInput): void {
  const { unitId, transactionId = 0, functionCode, direction, fields, force } = input;
  writeNumber(out, 2, transactionId, 'transactionId', force);
  writeNumber(out, 2, 0, 'protocolId', force);
  const at = out.length;
  // The number that the length field holds is known only after the rest is written.
  writeNumber(out, 2, 0, 'length', force);
  const counted = out.length;
  writeNumber(out, 1, unitId, 'unitId', force);
  writePdu(out, functionCode, direction, fields, force);
  if (force?.['length'] !== undefined) return;
  const length = wholeNumber(out.length - counted, 'length', 0, 0xffff);
  out.bytes[at] = length >>> 8;
  out.bytes[at + 1] = length & 0xff;
}

const COLON = '3A';
const CR_LF = '0D0A';
const DIGITS = Uint8Array.from('0123456789ABCDEF', (digit) => digit.charCodeAt(0));

function encodeAscii(out: Output, input: FrameInput): Uint8Array {
  const { force } = input;
  const characters = force?.['characters'];
  if (characters === undefined) writeSerial(out, input, LRC);
  const binary = characters === undefined ? out.take() : undefined;
  out.length = 0;
  out.pairs(force?.['start'] ?? COLON, 'start');
  if (binary === undefined) out.pairs(characters, 'characters');
  else writeCharacters(out, binary);
  out.pairs(force?.['end'] ?? CR_LF, 'end');
  if (force?.['after'] !== undefined) out.pairs(force['after'], 'after');
  return out.take();
}

/** Two upper-case hexadecimal digits a byte, the high one first (SL 2.5.2.1). */
function writeCharacters(out: Output, binary: Uint8Array): void {
  const at = out.grow(2 * binary.length);
  const { bytes } = out;
  for (let i = 0; i < binary.length; i++) {
    const byte = binary[i] as number;
    bytes[at + 2 * i] = DIGITS[byte >>> 4] as number;
    bytes[at + 2 * i + 1] = DIGITS[byte & 0x0f] as number;
  }
}
