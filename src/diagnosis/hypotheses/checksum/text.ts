import { crc16, hexDigits, MOST_RTU } from '../../../modbus/index.ts';
import { wrongCrcs } from '../../case.ts';
import { swapWord } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { aboutCrc, explainedBits } from './explained.ts';

const upper = (byte: number) => hexDigits(byte, 2);
const lower = (byte: number) => upper(byte).toLowerCase();

/** How one byte is written, and what stands between two. */
const WRITINGS: readonly ((byte: number) => string)[] = [
  upper,
  lower,
  (byte) => `0x${upper(byte)}`,
  (byte) => `0x${lower(byte)}`,
  (byte) => `\\x${upper(byte)}`,
  (byte) => `\\x${lower(byte)}`,
  (byte) => `${upper(byte)}h`,
  (byte) => hexDigits(byte, 1).toLowerCase(),
  (byte) => hexDigits(byte, 1),
  (byte) => byte.toString(),
];
const BETWEEN = [' ', '', ',', ', ', ':', '-', '\n'];
/** What may follow the last byte. */
const BEHIND = ['', '\n'];
export const TEXTS_TRIED = 2 * WRITINGS.length * BETWEEN.length * BEHIND.length;
/** How rare it is, in bits, compared with other mistakes (6): it is one of the most common. */
const COST = 5;
/** Nobody writes longer frames by hand, and each text takes time. */
const LONGEST = MOST_RTU;

/** A calculator took the CRC of the characters that were typed into it, not of the bytes they stand for. */
export const text: Hypothesis = {
  codes: ['crc-of-text'],
  offer: (item) =>
    wrongCrcs(item).flatMap((wrong) => {
      const found = textOf(item.bytes.subarray(0, Math.min(wrong.end, LONGEST + 1)), wrong.got);
      return found
        ? [{ code: 'crc-of-text', ...aboutCrc(item, wrong), ...found, bits: explainedBits(wrong, TEXTS_TRIED, COST) }]
        : [];
    }),
};

/** The text of these bytes that has this CRC-16/MODBUS. */
export function textOf(body: Uint8Array, got: number): { text: string; swapped: boolean } | undefined {
  if (body.length > LONGEST) return undefined;
  const other = swapWord(got);
  for (const write of WRITINGS) {
    const written = Array.from(body, write);
    for (const between of BETWEEN) {
      const end = put(written, between);
      for (const behind of BEHIND) {
        const value = crc16(CHARACTERS, 0, putText(behind, end));
        if (value === got || value === other) return { text: written.join(between) + behind, swapped: value !== got };
      }
    }
  }
  return undefined;
}

/** Room for any of the texts, so that only the right one is made a string. */
const CHARACTERS = new Uint8Array(8 * (LONGEST + 1));

/** Puts the characters of these pieces into `CHARACTERS`; returns where they end. */
function put(pieces: readonly string[], between: string): number {
  let at = 0;
  for (let i = 0; i < pieces.length; i++) {
    if (i > 0) at = putText(between, at);
    at = putText(pieces[i] as string, at);
  }
  return at;
}

function putText(text: string, at: number): number {
  for (let i = 0; i < text.length; i++) CHARACTERS[at + i] = text.charCodeAt(i);
  return at + text.length;
}
