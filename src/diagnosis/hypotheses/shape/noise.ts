import { decodeFrame } from '../../../modbus/index.ts';
import { type Case, wholesOf } from '../../case.ts';
import type { FindingData, Offer } from '../../finding.ts';
import { hasErrors, join } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { threeQuartersBits } from './three-quarters.ts';

type Pattern = FindingData['noise']['pattern'];

const COST = 4;
/** The fewest bytes in which a pattern shows. */
const LEAST = 4;

/**
 * A receiver that samples two, three or four times too fast sees each bit two, three or four times. Each character it sees
 * begins with an edge, and its start bit is the first sample: `mask` pairs the others.
 */
const SAMPLED = [
  { times: 2, zeros: 0x01, pairs: [0x06, 0x18, 0x60] },
  { times: 3, zeros: 0x03, pairs: [0x1c, 0xe0] },
  { times: 4, zeros: 0x07, pairs: [0x78] },
] as const;

/** Not a frame. The settings of the line sometimes show in the bits. */
export const noise: Hypothesis = {
  codes: ['noise'],
  offer: (item) => {
    const { length } = item.bytes;
    if (length === 0) return [];
    return [
      unknown(item),
      ...constant(item),
      ...sampled(item),
      ...sampledTooSlowly(item),
      ...sampledAtThreeQuarters(item),
      ...parity(item),
      ...mirrored(item),
    ];
  },
};

const found = (
  { bytes }: Case,
  pattern: Pattern,
  bits: number,
  { times, repaired = [] }: { times?: number; repaired?: readonly Uint8Array[] } = {},
): Offer => ({ code: 'noise', from: 0, to: bytes.length, pattern, times, repaired, bits });

/** What everything else is measured against. */
const unknown = (item: Case) => found(item, 'unknown', 0);

/** A line that is broken, not driven, or held. */
function constant(item: Case): Offer[] {
  const { bytes } = item;
  const [first] = bytes;
  if (bytes.length < 3 || (first !== 0x00 && first !== 0xff) || !bytes.every((byte) => byte === first)) return [];
  return [found(item, 'constant', Math.min(30, 8 * bytes.length) - COST)];
}

function sampled(item: Case): Offer[] {
  const { bytes } = item;
  if (bytes.length < LEAST) return [];
  return SAMPLED.flatMap(({ times, zeros, pairs }) => {
    const fits = (byte: number) =>
      (byte & zeros) === 0 && pairs.every((pair) => (byte & pair) === 0 || (byte & pair) === pair);
    if (!bytes.every(fits) || bytes.every((byte) => byte === 0)) return [];
    const each = 4 + (times === 2 ? 0 : 1);
    return [found(item, 'too-fast', Math.min(30, each * bytes.length) - COST, { times })];
  });
}

/**
 * At half the speed every second bit is seen, of two characters at a time: the fourth is the stop bit of
 * the first character, which is always 1.
 */
function sampledTooSlowly(item: Case): Offer[] {
  const { bytes } = item;
  if (bytes.length < LEAST - 1 || !bytes.every((byte) => (byte & STOP_BIT) !== 0)) return [];
  return [found(item, 'too-slow', Math.min(30, bytes.length) - 1, { times: 1 / 2 })];
}
const STOP_BIT = 0x08;
const FAINT = 5;
/** Less evidence than this speaks against a frame, but not for this speed. */
const SHOWN = 6;

function sampledAtThreeQuarters(item: Case): Offer[] {
  const bits = Math.min(30, threeQuartersBits(item.bytes));
  // Any bytes show it faintly, so it means nothing beside a frame that is far more likely.
  const likelier = Math.max(0, ...item.bodies.map((body) => body.bits - FAINT));
  if (bits <= likelier) return [];
  return [bits < SHOWN ? found(item, 'unknown', bits) : found(item, 'too-slow', bits, { times: 3 / 4 })];
}

/** Seven data bits and a parity bit, read as eight data bits. */
function parity(item: Case): Offer[] {
  const { bytes } = item;
  if (bytes.length < 2 * LEAST) return [];
  const [first] = bytes;
  const of = odd(first as number);
  const mixed = bytes.some((byte) => byte > 0x7f);
  if (!mixed || !bytes.every((byte) => odd(byte) === of)) return [];
  const seven = bytes.map((byte) => byte & 0x7f);
  const reading = decodeFrame(seven, { transport: 'ascii', direction: 'request' });
  const ascii =
    wholesOf(seven, 'ascii', item.request).length > 0 || wholesOf(join(seven, [0x0a]), 'ascii', undefined).length > 0;
  const repaired = ascii && !hasErrors(reading) ? [seven] : [];
  return [found(item, 'parity', Math.min(30, bytes.length - 1 + (ascii ? 16 : 0)) - COST, { repaired })];
}

const odd = (byte: number): number => {
  let bits = byte;
  bits ^= bits >> 4;
  bits ^= bits >> 2;
  return (bits ^ (bits >> 1)) & 1;
};

/** Every byte is a frame's, with ones and zeros exchanged or its bits in reverse. */
function mirrored(item: Case): Offer[] {
  const { bytes, bodies, request, cut } = item;
  if (cut || bodies.length === 0) return [];
  const ways = [
    { pattern: 'polarity', turned: bytes.map((byte) => ~byte & 0xff) },
    { pattern: 'bit-order', turned: bytes.map(reversed) },
  ] as const;
  return ways.flatMap(({ pattern, turned }) => {
    const whole = wholesOf(turned, 'rtu', request).find(({ reading }) => !hasErrors(reading));
    return whole ? [found(item, pattern, whole.bits - 2 - COST, { repaired: [turned] })] : [];
  });
}

function reversed(byte: number): number {
  let turned = 0;
  for (let bit = 0; bit < 8; bit++) turned = (turned << 1) | ((byte >> bit) & 1);
  return turned;
}
