import type { Force, Values } from './field.ts';
import { acceptHex } from './fields/hex.ts';
import { wholeNumber } from './fields/number.ts';
import { fromHex } from './hex.ts';
import { type PduPlan, planPdu, writePdu } from './pdu.ts';
import type { Direction, Transport } from './reading.ts';
import { type Checksum, CRC, LRC } from './serial.ts';

/** A frame as a person says it. */
export interface FrameInput {
  readonly transport: Transport;
  readonly direction: Direction;
  /** 0…255; not needed for a bare PDU. */
  readonly unitId?: number | undefined;
  /** TCP: 0…65535, 0 where it is left out. */
  readonly transactionId?: number | undefined;
  /** 0…255; a reply with the exception bit set (80 and above) carries the field `exceptionCode`. */
  readonly functionCode?: number | undefined;
  /** The function's fields by name. Names that the encoder derives, and names it does not know, are ignored. */
  readonly fields: Values;
  /**
   * Values that replace derived ones: a number, or hexadecimal pairs for bytes verbatim (`''` for none). `checksum` as a
   * number is the CRC register or the LRC. `rest` adds bytes to the PDU, `after` behind the frame; `padding` and
   * `rawValue` set the unused bits of a bit field and the raw value of a coil; `start`, `characters` and `end` replace
   * those parts of an ASCII frame.
   */
  readonly force?: Force | undefined;
}

/**
 * The bytes of a frame (AP 4.1; SL 2.5; TG 3.1.3). Throws a `FrameError` for what has no bytes, such as 70000 in 16 bits;
 * what has bytes but breaks a rule is encoded, and reported when it is decoded.
 */
export function encodeFrame(input: FrameInput): Uint8Array {
  const { force } = input;
  const plan = planPdu(input.functionCode, input.direction, input.fields, force);
  switch (input.transport) {
    case 'rtu':
      return encodeSerial(input, plan, CRC, force?.['after']);
    case 'ascii':
      return encodeAscii(input, plan);
    case 'tcp':
      return encodeTcp(input, plan);
    case 'pdu': {
      const after = verbatim(force, 'after');
      const out = new Uint8Array(plan.length + after.length);
      writePdu(out, 0, plan, force);
      out.set(after, plan.length);
      return out;
    }
    default:
      throw new TypeError(`transport: ${String(input.transport)} is not rtu, ascii, tcp or pdu`);
  }
}

const NO_BYTES = new Uint8Array(0);

/** The bytes a name is forced to verbatim; none where it is not, or not verbatim. */
function verbatim(force: Force | undefined, name: string): Uint8Array {
  const value = force?.[name];
  return typeof value === 'string' ? (fromHex(acceptHex(value, name)) as Uint8Array) : NO_BYTES;
}

/** Bytes of a number of the envelope: verbatim where forced so, else `width` of them. */
function widthOf(force: Force | undefined, name: string, width: number): number {
  return typeof force?.[name] === 'string' ? verbatim(force, name).length : width;
}

function encodeSerial(
  { unitId, force }: FrameInput,
  plan: PduPlan,
  checksum: Checksum,
  behind: number | string | undefined,
): Uint8Array {
  const unitWidth = widthOf(force, 'unitId', 1);
  const checksumWidth = widthOf(force, 'checksum', checksum.width);
  const after = behind === undefined ? NO_BYTES : verbatim(force, 'after');
  const end = unitWidth + plan.length;
  const out = new Uint8Array(end + checksumWidth + after.length);
  writeNumber(out, 0, 1, unitId, force, 'unitId');
  writePdu(out, unitWidth, plan, force);
  const forced = force?.['checksum'];
  if (typeof forced === 'string') out.set(verbatim(force, 'checksum'), end);
  else if (forced === undefined) checksum.write(out, end, checksum.compute(out, 0, end));
  else checksum.write(out, end, wholeNumber(forced, 'checksum', 0, checksum.width === 1 ? 0xff : 0xffff));
  if (after.length > 0) out.set(after, end + checksumWidth);
  return out;
}

/** Writes a number of the envelope, high byte first, or the bytes it is forced to. Returns the place behind it. */
function writeNumber(
  out: Uint8Array,
  at: number,
  width: 1 | 2,
  value: number | undefined,
  force: Force | undefined,
  name: string,
): number {
  const forced = force?.[name];
  if (typeof forced === 'string') {
    const bytes = verbatim(force, name);
    out.set(bytes, at);
    return at + bytes.length;
  }
  const number = wholeNumber(forced ?? value, name, 0, width === 1 ? 0xff : 0xffff);
  if (width === 2) out[at] = number >>> 8;
  out[at + width - 1] = number & 0xff;
  return at + width;
}

function encodeTcp({ unitId, transactionId = 0, force }: FrameInput, plan: PduPlan): Uint8Array {
  const width = widthOf(force, 'transactionId', 2) + widthOf(force, 'protocolId', 2) + widthOf(force, 'length', 2);
  const unitWidth = widthOf(force, 'unitId', 1);
  const after = verbatim(force, 'after');
  const end = width + unitWidth + plan.length;
  const out = new Uint8Array(end + after.length);
  let at = writeNumber(out, 0, 2, transactionId, force, 'transactionId');
  at = writeNumber(out, at, 2, 0, force, 'protocolId');
  at = writeNumber(out, at, 2, unitWidth + plan.length, force, 'length');
  at = writeNumber(out, at, 1, unitId, force, 'unitId');
  writePdu(out, at, plan, force);
  if (after.length > 0) out.set(after, end);
  return out;
}

const COLON = new Uint8Array([0x3a]);
const CR_LF = new Uint8Array([0x0d, 0x0a]);
const DIGITS = Uint8Array.from('0123456789ABCDEF', (digit) => digit.charCodeAt(0));

function encodeAscii(input: FrameInput, plan: PduPlan): Uint8Array {
  const { force } = input;
  const part = (name: string, otherwise: Uint8Array) =>
    force?.[name] === undefined ? otherwise : verbatim(force, name);
  const start = part('start', COLON);
  const characters =
    force?.['characters'] === undefined
      ? toCharacters(encodeSerial(input, plan, LRC, undefined))
      : verbatim(force, 'characters');
  const end = part('end', CR_LF);
  const out = new Uint8Array(start.length + characters.length + end.length + verbatim(force, 'after').length);
  out.set(start);
  out.set(characters, start.length);
  out.set(end, start.length + characters.length);
  out.set(verbatim(force, 'after'), start.length + characters.length + end.length);
  return out;
}

/** Two upper-case hexadecimal digits a byte, the high one first (SL 2.5.2.1). */
function toCharacters(bytes: Uint8Array): Uint8Array {
  const characters = new Uint8Array(2 * bytes.length);
  for (let i = 0; i < bytes.length; i++) {
    const byte = bytes[i] as number;
    characters[2 * i] = DIGITS[byte >>> 4] as number;
    characters[2 * i + 1] = DIGITS[byte & 0x0f] as number;
  }
  return characters;
}
