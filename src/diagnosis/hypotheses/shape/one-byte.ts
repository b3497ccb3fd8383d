import { crc16, FIRST_UNIT, LAST_UNIT, MOST_RTU } from '../../../modbus/index.ts';
import { type Case, wholesOf } from '../../case.ts';
import { tries } from '../../evidence.ts';
import type { Offer } from '../../finding.ts';
import { hasErrors, join } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';

const LONGEST = MOST_RTU + 1;
const COST = 9;
/** Bytes that programs and lines swallow: the end of a string, line ends, XON and XOFF, an idle line. */
const SWALLOWED = [0x00, 0x0d, 0x0a, 0x11, 0x13, 0xff];

/** One byte inside the frame is too many, or was swallowed on the way. */
export const oneByte: Hypothesis = {
  codes: ['byte-inserted', 'byte-lost'],
  offer: (item) => {
    const { bytes, bodies, cut } = item;
    if (cut || bodies.length === 0 || bytes.length < 5 || bytes.length > LONGEST) return [];
    return [...inserted(item), ...lost(item), ...lostInFront(item)];
  },
};

const bitsOf = (frame: Uint8Array, { request }: Case, tried: number): number[] =>
  wholesOf(frame, 'rtu', request)
    .filter(({ reading }) => !hasErrors(reading) && !reading.open)
    .map(({ bits }) => bits - tries(tried) - COST);

/** An extra first or last byte is another finding: a stray byte before or behind. */
function inserted(item: Case): Offer[] {
  const { bytes } = item;
  const offers: Offer[] = [];
  for (let at = 1; at < bytes.length - 1; at++) {
    // Of equal bytes in a row, any one may be the extra one.
    if (bytes[at] === bytes[at - 1]) continue;
    const frame = join(bytes.subarray(0, at), bytes.subarray(at + 1));
    if (crc16(frame) !== 0) continue;
    for (const bits of bitsOf(frame, item, bytes.length)) {
      offers.push({
        code: 'byte-inserted',
        from: at,
        to: at + 1,
        at,
        got: bytes[at] as number,
        repaired: [frame],
        bits,
      });
    }
  }
  return offers;
}

function lost(item: Case): Offer[] {
  const { bytes } = item;
  const offers: Offer[] = [];
  for (const byte of SWALLOWED) {
    for (let at = 1; at < bytes.length; at++) {
      if (bytes[at] === byte) continue;
      const frame = join(bytes.subarray(0, at), [byte], bytes.subarray(at));
      if (crc16(frame) !== 0) continue;
      for (const bits of bitsOf(frame, item, SWALLOWED.length * bytes.length)) {
        offers.push({ code: 'byte-lost', from: at, to: at + 1, at, lost: byte, repaired: [frame], bits });
      }
    }
  }
  return offers;
}

/** The first byte, the unit identifier, is lost most often, because the line was switched over too late. */
function lostInFront(item: Case): Offer[] {
  const { bytes, request } = item;
  const asked = request?.unitId;
  const units = asked === undefined ? ALL_UNITS : [asked];
  return units.flatMap((unit): Offer[] => {
    const frame = join([unit], bytes);
    if (crc16(frame) !== 0) return [];
    return bitsOf(frame, item, units.length).map((bits) => ({
      code: 'byte-lost',
      from: 0,
      to: 1,
      at: 0,
      lost: unit,
      repaired: [frame],
      bits: bits + IN_FRONT,
    }));
  });
}

const ALL_UNITS = Array.from({ length: LAST_UNIT }, (_, i) => FIRST_UNIT + i);
/** How much more often, in bits, a byte is lost there than anywhere else. */
const IN_FRONT = 3;
