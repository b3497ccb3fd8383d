import { type CatalogueCrc, crc, crcCatalogue, sum8, xor8 } from '../../../modbus/index.ts';
import { type Body, type Case, type WrongCrc, wrongCrcs } from '../../case.ts';
import { endsThere, tries } from '../../evidence.ts';
import type { Offer } from '../../finding.ts';
import { swapWord, withCrc } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { aboutCrc, explainedBits } from './explained.ts';

const MODBUS = crcCatalogue.find(({ name }) => name === 'CRC-16/MODBUS') as CatalogueCrc;
const ofWidth = (width: number) => crcCatalogue.filter((row) => row.width === width && row !== MODBUS);
const WORDS = ofWidth(16);
const LONG = ofWidth(32);
const SHORT = ofWidth(8);

/** Start values that are set by mistake, FFFF being right, and how rare each is against zero, in bits. */
const STARTS = [
  { row: { ...MODBUS, init: 0x0000 }, rarity: -1 },
  { row: { ...MODBUS, init: 0x00ff }, rarity: 5 },
  { row: { ...MODBUS, init: 0xff00 }, rarity: 5 },
  { row: { ...MODBUS, init: 0x1d0f }, rarity: 5 },
];
const TRIED = 2 * (WORDS.length + STARTS.length);

/** Another checksum stands where the CRC belongs: another polynomial, start value or final xor, or a sum. */
export const algorithm: Hypothesis = {
  codes: ['crc-algorithm', 'crc-start-value'],
  offer: (item) => [
    ...wrongCrcs(item).flatMap((wrong) => sixteenBits(item, wrong)),
    ...otherWidth(item, 1, [...SHORT.map(sumOf), { name: 'SUM-8', value: sum8 }, { name: 'XOR-8', value: xor8 }]),
    ...otherWidth(item, 4, LONG.map(sumOf)),
  ],
};

function sixteenBits(item: Case, wrong: WrongCrc): Offer[] {
  const { bytes } = item;
  const { end, got } = wrong;
  const bits = explainedBits(wrong, TRIED);
  const other = swapWord(got);
  const offers: Offer[] = [];
  for (const { row, rarity } of STARTS) {
    if (crc(row, bytes, 0, end) !== got) continue;
    offers.push({ code: 'crc-start-value', ...aboutCrc(item, wrong), start: row.init, bits: bits - rarity });
  }
  for (const row of WORDS) {
    const value = crc(row, bytes, 0, end);
    if (value !== got && value !== other) continue;
    // Sent low byte first as here, where it is a number with the low byte at the end otherwise.
    const swapped = value !== got;
    offers.push({ code: 'crc-algorithm', ...aboutCrc(item, wrong), algorithm: row.name, swapped, bits });
  }
  return offers;
}

interface Sum {
  readonly name: string;
  value(bytes: Uint8Array, from: number, to: number): number;
}
const sumOf = (row: CatalogueCrc): Sum => ({
  name: row.name,
  value: (bytes, from, to) => crc(row, bytes, from, to),
});

/** A checksum of one byte or four, behind a body that ends just before it. */
function otherWidth({ bytes, bodies, cut }: Case, width: 1 | 4, sums: readonly Sum[]): Offer[] {
  const end = bytes.length - width;
  const complete = (body: Body) => body.end === end && !body.reading.open;
  if (cut || end < 2) return [];
  return bodies.filter(complete).flatMap((body) => {
    const high = Array.from(bytes.subarray(end));
    const highFirst = high.reduce((value, byte) => value * 256 + byte, 0);
    const lowFirst = high.reduceRight((value, byte) => value * 256 + byte, 0);
    return sums.flatMap(({ name, value }): Offer[] => {
      const got = value(bytes, 0, end);
      if (got !== highFirst && got !== lowFirst) return [];
      const repaired = withCrc(bytes.subarray(0, end));
      const expected = (repaired[end] as number) | ((repaired[end + 1] as number) << 8);
      const bits = body.bits + endsThere(body.reading) + 8 * width - tries(2 * sums.length) - 7;
      const found = { got, expected, algorithm: name, swapped: got !== lowFirst };
      return [{ code: 'crc-algorithm', from: end, to: bytes.length, repaired: [repaired], ...found, bits }];
    });
  });
}
