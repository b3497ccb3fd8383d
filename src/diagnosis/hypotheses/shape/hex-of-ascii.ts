import { lrc, type Transport } from '../../../modbus/index.ts';
import { type AsciiText, asciiText, textBits } from '../../ascii-text.ts';
import { type Case, wholesOf } from '../../case.ts';
import type { Offer } from '../../finding.ts';
import { hasErrors } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { bodyOf, carriedBy } from '../../request.ts';

const MBAP = 7;
/** Unit identifier, function code and LRC as pairs of digits, and the colon: fewer characters may be there by chance. */
const LEAST = 7;
const COST = 6;
/** The bits of a byte that is a digit, a colon, CR or LF. */
const CHARACTER_BITS = 3;
/** The bits of a protocol identifier of zero, less how rare such gateways are. */
const HEADER = 13;

/** Hexadecimal text was sent or received where bytes belong: an ASCII frame, or the digits of another frame. */
export const hexOfAscii: Hypothesis = {
  codes: ['hex-of-ascii-frame'],
  offer: (item) => [...asText(item), ...inMbap(item)],
};

function asText(item: Case): Offer[] {
  // On an ASCII line characters are expected.
  const found = item.cut || item.transport === 'ascii' ? undefined : asciiText(item.bytes);
  if (found === undefined || found.binary.length < 3) return [];
  const { binary, text } = found;
  const meant = framesSaid(item, found);
  const isLrc = lrc(binary) === 0;
  // The checksum holds over the bytes that the digits spell, even if they break a rule and cannot be repaired.
  const isCrc = meant.length === 0 && !found.colon && wholesOf(binary, 'rtu', item.request).length > 0;
  if (meant.length === 0 && !isLrc && !isCrc) return [];
  const instead = isLrc ? [carriedBy(item.transport ?? 'ascii', binary.subarray(0, -1))] : [];
  const repaired = meant.length > 0 ? meant : instead;
  const bits = textBits(found) + (isLrc ? 8 : 0) + (meant.length > 0 || isCrc ? 8 : 0) - COST;
  return [{ code: 'hex-of-ascii-frame', from: 0, to: item.bytes.length, text, inMbap: false, repaired, bits }];
}

/** The frames that the digits spell, in the wanted transport. */
function framesSaid(item: Case, { binary, colon }: AsciiText): Uint8Array[] {
  const transports: readonly Transport[] = colon ? [] : ['rtu', 'tcp', 'ascii'];
  const inside = transports.flatMap((transport) => {
    const whole = wholesOf(binary, transport, item.request).find(({ reading }) => !hasErrors(reading));
    const body = whole && bodyOf(whole.reading, binary);
    return body ? [carriedBy(item.transport ?? transport, body, whole.reading.transactionId)] : [];
  });
  return inside.slice(0, 1);
}

/** Characters behind an MBAP header: a gateway passed on an ASCII line without translating it. */
function inMbap({ bytes, transport, cut }: Case): Offer[] {
  if (cut || (transport !== undefined && transport !== 'tcp') || bytes.length < MBAP + 2) return [];
  if (bytes[2] !== 0 || bytes[3] !== 0) return [];
  const inside = bytes.subarray(MBAP);
  if (!inside.every(isCharacter)) return [];
  const bits = HEADER + CHARACTER_BITS * inside.length;
  const text = String.fromCharCode(...inside.subarray(0, 520));
  const guess = inside.length < LEAST;
  return [{ code: 'hex-of-ascii-frame', from: MBAP, to: bytes.length, text, inMbap: true, repaired: [], bits, guess }];
}

const isCharacter = (byte: number) =>
  (byte >= 0x30 && byte <= 0x3a) || (byte >= 0x41 && byte <= 0x46) || byte === 0x0d || byte === 0x0a;
