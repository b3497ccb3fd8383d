import { type Case, wholesOf } from '../../case.ts';
import type { Offer } from '../../finding.ts';
import { hasErrors, sumOf } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';

/** Solarman V5: A5, length (2), control code (2), sequence (2), serial number of the logger (4), payload, sum, 15. */
const START = 0xa5;
const END = 0x15;
const HEADER = 11;
const TRAILER = 2;
/** The last byte of the control code, in requests and in replies. */
const CONTROL = 0x10;
/** What stands in the payload in front of the RTU frame. */
const BEFORE = { request: 15, response: 14 } as const;
/** Start, end, control code, length and sum. */
const MARKS = 40;

/** An RTU frame in the envelope in which a data logger carries it over TCP. */
export const envelope: Hypothesis = {
  codes: ['envelope'],
  offer: (item) => {
    const { bytes, cut } = item;
    const length = (bytes[1] ?? 0) | ((bytes[2] ?? 0) << 8);
    const end = HEADER + length;
    if (cut || bytes[0] !== START || bytes[3] !== CONTROL || end + TRAILER > bytes.length) return [];
    if (bytes[end + 1] !== END) return [];
    const sum = sumOf(bytes, 1, end) & 0xff;
    const serial =
      ((bytes[7] ?? 0) | ((bytes[8] ?? 0) << 8) | ((bytes[9] ?? 0) << 16) | ((bytes[10] ?? 0) << 24)) >>> 0;
    return [inside(item, end, { protocol: 'solarman-v5', serial, holds: sum === bytes[end] })];
  },
};

/** The frame inside, behind the prefix of a request or of a reply, if it is sound behind one of them. */
function inside({ bytes, request }: Case, end: number, told: Told): Offer {
  const places = [HEADER + BEFORE.response, HEADER + BEFORE.request].filter((from) => from < end);
  const from = places.find((place) => wholesOf(bytes.subarray(place, end), 'rtu', request).length > 0) ?? HEADER;
  const frame = bytes.slice(from, end);
  const whole = wholesOf(frame, 'rtu', request).find(({ reading }) => !hasErrors(reading));
  const bits = MARKS - (told.holds ? 0 : SUM_BITS);
  return { code: 'envelope', from, to: end, ...told, repaired: whole ? [frame] : [], bits };
}

const SUM_BITS = 8;

interface Told {
  readonly protocol: 'solarman-v5';
  readonly serial: number;
  readonly holds: boolean;
}
