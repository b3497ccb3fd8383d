import { layout } from '../field.ts';
import { bits } from '../fields/bits.ts';
import { address, bytesOfBits, count, fitsRequest, lengthOf, quantity } from '../fields/number.ts';

/** Most coils or inputs in one reply: 250 bytes of bits (AP 6.1, AP 6.2). */
const MOST = 2000;

/** What 01 and 02 ask: a start address and how many bits. */
export const readBitsRequest = layout([
  address('startAddress'),
  quantity('quantity', { from: 'startAddress', least: 1, most: MOST }),
]);

/** What 01 and 02 answer. The quantity is not in it: only the request tells how many bits of the last byte count. */
export const readBitsResponse = layout([
  count('byteCount', {
    least: 1,
    most: bytesOfBits(MOST),
    derive: lengthOf('bits', bytesOfBits),
    replyRules: [fitsRequest('quantity', bytesOfBits)],
  }),
  bits('bits', {
    size: ({ count }) => count,
    quantity: ({ request }) => request?.fields['quantity'] as number | undefined,
  }),
]);
