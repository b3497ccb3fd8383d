import { type Checksum, checksum, checksums } from '../../../modbus/index.ts';
import { type Body, type Case, type WrongCrc, wrongCrcs } from '../../case.ts';
import { matching } from '../../checksum-match.ts';
import { endsThere, tries } from '../../evidence.ts';
import type { Offer } from '../../finding.ts';
import { withCrc } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { aboutCrc, explainedBits } from './explained.ts';

const MODBUS = checksums.find(({ name }) => name === 'CRC-16/MODBUS') as Checksum;
/** The right one, and the LRC, which is another finding. */
const JUDGED_APART = new Set(['CRC-16/MODBUS', 'LRC']);
const ofWidth = (bits: number) => checksums.filter(({ width, name }) => width === bits && !JUDGED_APART.has(name));
const WORDS = ofWidth(16);
const LONG = ofWidth(32);
const SHORT = ofWidth(8);

/** Start values that are set by mistake, FFFF being right, and how rare each is compared with zero, in bits. */
const STARTS = [
  { start: 0x0000, rarity: -1 },
  { start: 0x00ff, rarity: 5 },
  { start: 0xff00, rarity: 5 },
  { start: 0x1d0f, rarity: 5 },
].map(({ start, rarity }) => ({ start, rarity, from: { ...MODBUS, start } }));
const TRIED = 2 * (WORDS.length + STARTS.length);

/** Another checksum stands where the CRC belongs: another polynomial, start value or final xor, or a sum. */
export const algorithm: Hypothesis = {
  codes: ['crc-algorithm', 'crc-start-value'],
  offer: (item) => [
    ...wrongCrcs(item).flatMap((wrong) => sixteenBits(item, wrong)),
    ...otherWidth(item, 1, SHORT),
    ...otherWidth(item, 4, LONG),
  ],
};

function sixteenBits(item: Case, wrong: WrongCrc): Offer[] {
  const { bytes } = item;
  const { end, got } = wrong;
  const bits = explainedBits(wrong, TRIED);
  const offers: Offer[] = [];
  for (const { start, rarity, from } of STARTS) {
    if (checksum(from, bytes, 0, end) !== got) continue;
    offers.push({ code: 'crc-start-value', ...aboutCrc(item, wrong), start, bits: bits - rarity });
  }
  for (const { of, lowFirst } of matching(WORDS, bytes, 0, end, bytes.subarray(end))) {
    // Sent low byte first here; elsewhere such numbers end with the low byte.
    offers.push({ code: 'crc-algorithm', ...aboutCrc(item, wrong), algorithm: of.name, swapped: !lowFirst, bits });
  }
  return offers;
}

/** A checksum of one byte or four, behind a body that ends just before it. */
function otherWidth({ bytes, bodies, cut }: Case, width: 1 | 4, sums: readonly Checksum[]): Offer[] {
  const end = bytes.length - width;
  const complete = (body: Body) => body.end === end && !body.reading.open;
  if (cut || end < 2) return [];
  return bodies.filter(complete).flatMap((body) => {
    return matching(sums, bytes, 0, end, bytes.subarray(end)).map(({ of, got, lowFirst }): Offer => {
      const repaired = withCrc(bytes.subarray(0, end));
      const expected = (repaired[end] as number) | ((repaired[end + 1] as number) << 8);
      const bits = body.bits + endsThere(body.reading) + 8 * width - tries(2 * sums.length) - 7;
      const found = { got, expected, algorithm: of.name, swapped: !lowFirst };
      return { code: 'crc-algorithm', from: end, to: bytes.length, repaired: [repaired], ...found, bits };
    });
  });
}
