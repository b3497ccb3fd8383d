import { demandPart } from '../demand.ts';

/** The most words, each of two pairs of bytes, whose sums do not overflow into each other. */
const WORDS_AT_ONCE = 128;

/** The sum of `bytes[from, to)` modulo 256; four bytes at a time, because files are summed with it too. */
export function byteSum(bytes: Uint8Array, from: number, to: number): number {
  demandPart(bytes, from, to);
  let sum = 0;
  let i = from;
  for (; i < to && (bytes.byteOffset + i) % 4 !== 0; i++) sum += bytes[i] as number;
  if (i >= to) return sum & 0xff;
  const words = new Uint32Array(bytes.buffer, bytes.byteOffset + i, Math.max(0, to - i) >> 2);
  for (let at = 0; at < words.length; ) {
    const end = Math.min(at + WORDS_AT_ONCE, words.length);
    let even = 0;
    let odd = 0;
    for (; at < end; at++) {
      const word = words[at] as number;
      even += word & 0xff00ff;
      odd += (word >>> 8) & 0xff00ff;
    }
    sum = (sum + even + (even >>> 16) + odd + (odd >>> 16)) & 0xff;
  }
  for (i += 4 * words.length; i < to; i++) sum += bytes[i] as number;
  return sum & 0xff;
}
