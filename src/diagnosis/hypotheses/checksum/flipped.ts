import { crc16, MOST_RTU } from '../../../modbus/index.ts';
import { type Case, wholesOf } from '../../case.ts';
import { tries } from '../../evidence.ts';
import type { Offer } from '../../finding.ts';
import { hasErrors, replaced } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';

const SHORTEST = 4;
/** How rare it is, in bits. It is better to leave bytes unexplained than to give a second-best explanation. */
const COST = 9.2;

/** How one byte changes a register of zero; the high byte of each entry is unique. */
const CHANGES = Uint16Array.from({ length: 256 }, (_, byte) => crc16(Uint8Array.of(byte)) ^ crc16(Uint8Array.of(0)));
const BY_HIGH = Uint8Array.from({ length: 256 }, (_, high) => CHANGES.findIndex((change) => change >>> 8 === high));

/** One byte, or one bit of it, is not what was sent; with it corrected the CRC holds. */
export const flipped: Hypothesis = {
  codes: ['bit-error', 'byte-error'],
  offer: (item) => {
    const { bytes, cut } = item;
    const { length } = bytes;
    // In bytes longer than any RTU frame, no single fault can be told from chance.
    if (cut || length < SHORTEST || length > MOST_RTU || item.bodies.length === 0) return [];
    return changesThatHelp(bytes).flatMap((change) => offerFor(item, change));
  },
};

interface Change {
  readonly at: number;
  /** What the byte must be exclusive-ored with. */
  readonly by: number;
}

/**
 * Every change of one byte that makes the CRC hold, in one pass: CRCs are linear over xor, so the difference between the
 * two CRCs is that of the wrong byte alone, moved on by the bytes behind it. It is moved back byte by byte.
 */
function changesThatHelp(bytes: Uint8Array): Change[] {
  const end = bytes.length - 2;
  let difference = crc16(bytes, 0, end) ^ ((bytes[end] as number) | ((bytes[end + 1] as number) << 8));
  if (difference === 0) return [];
  const changes: Change[] = [];
  if (difference < 0x100) changes.push({ at: end, by: difference });
  if ((difference & 0xff) === 0) changes.push({ at: end + 1, by: difference >>> 8 });
  for (let at = end - 1; at >= 0; at--) {
    const byte = BY_HIGH[difference >>> 8] as number;
    difference = ((difference ^ (CHANGES[byte] as number)) << 8) | byte;
    if (difference < 0x100) changes.push({ at, by: difference });
  }
  return changes;
}

function offerFor({ bytes, request }: Case, { at, by }: Change): Offer[] {
  const got = bytes[at] as number;
  const expected = got ^ by;
  const repaired = replaced(bytes, at, expected);
  const bit = Math.log2(by);
  const single = Number.isInteger(bit);
  const tried = (single ? 8 : 255) * bytes.length;
  return wholesOf(repaired, 'rtu', request)
    .filter(({ reading }) => !hasErrors(reading))
    .map(({ bits }) => {
      const found = { from: at, to: at + 1, at, got, expected, repaired: [repaired], bits: bits - tries(tried) - COST };
      return single ? { code: 'bit-error', bit, ...found } : { code: 'byte-error', others: 0, ...found };
    });
}
