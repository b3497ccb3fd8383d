import { crc16, lrc } from '../../../modbus/index.ts';
import { asciiText, textBits } from '../../ascii-text.ts';
import { bodyAt, type Case } from '../../case.ts';
import { endsThere, tries } from '../../evidence.ts';
import type { Offer } from '../../finding.ts';
import { DIRECTIONS } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { carriedBy } from '../../request.ts';

/** How rare it is, in bits, as for a wrong CRC: unexplained, and explained. */
const COST = 6;

/** The checksum of an ASCII frame is wrong, or it is the CRC of RTU frames. */
export const asciiChecksum: Hypothesis = {
  codes: ['lrc-wrong', 'lrc-missing', 'crc-instead-of-lrc'],
  offer: (item) => {
    const found = item.transport === undefined || item.transport === 'ascii' ? asciiText(item.bytes) : undefined;
    if (!found?.colon || item.cut) return [];
    const directions = item.request ? (['response'] as const) : DIRECTIONS;
    return directions.flatMap((direction) => ofBinary(item, found.binary, direction, textBits(found)));
  },
};

function ofBinary({ request }: Case, binary: Uint8Array, direction: 'request' | 'response', format: number): Offer[] {
  const at = (byte: number) => 1 + 2 * byte;
  const offers: Offer[] = [];
  for (const width of [0, 1, 2]) {
    const end = binary.length - width;
    if (end < 2) continue;
    const body = binary.subarray(0, end);
    const { reading, end: own, bits } = bodyAt(body, 0, direction, request);
    if (own !== end) continue;
    const got = width === 1 ? (binary[end] as number) : (binary[end] as number) | ((binary[end + 1] as number) << 8);
    const expected = lrc(body);
    const place = { from: at(end), to: at(binary.length), got, expected, repaired: [carriedBy('ascii', body)] };
    const evidence = bits + format + endsThere(reading);
    if (width === 0 && lrc(binary) !== 0) {
      const absent = { from: 0, to: at(end), expected, repaired: place.repaired };
      offers.push({ code: 'lrc-missing', ...absent, bits: evidence - COST });
    }
    if (width === 1 && got !== expected) offers.push({ code: 'lrc-wrong', ...place, bits: evidence - COST });
    if (width === 2 && got === crc16(body)) {
      offers.push({ code: 'crc-instead-of-lrc', ...place, bits: evidence + 16 - tries(2) - COST });
    }
  }
  return offers;
}
