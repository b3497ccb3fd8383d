/**
 * A receiver at three quarters of the speed (14400 for 19200) takes a sample every 4/3 bits: of the bits that are sent it sees
 * these, counted from the falling edge that it takes for its start bit.
 */
const SEEN = [2, 3, 4, 6, 7, 8, 10, 11] as const;
/** Where it begins to look for the next falling edge. */
const NEXT = 12;
/** Bits of a character as sent: a start bit, which is 0, eight of data, and a stop bit, which is 1 (SL 2.5.1). */
const CHARACTER = 10;
const BITS = 8;

/** The chance that a bit of a character is 1. After the last character the line is idle, so nothing is sure. */
const ANY_BYTE = [0.02, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.98];
/** Function codes are small numbers, and some are exceptions (AP 5, AP 7). */
const FUNCTION_CODE = [0.02, 0.5, 0.5, 0.4, 0.15, 0.2, 0.03, 0.03, 0.1, 0.98];

/** The chance of 1 for each place: the unit identifier, the function code, and any byte after them. */
const ONES: readonly number[] = [...ANY_BYTE, ...FUNCTION_CODE, ...ANY_BYTE];
const KNOWN = 2 * CHARACTER;
/** All characters after the function code are alike. */
const placeOf = (bit: number): number => (bit < KNOWN ? bit : KNOWN + (bit % CHARACTER));
const one = (bit: number): number => ONES[placeOf(bit)] ?? 0.5;

/**
 * How much better than chance it explains bytes, in bits, that they were sampled at three quarters of the speed: log2 of the odds.
 * The receiver may have taken any bit of a character for its start bit, so the odds are summed over all of them.
 */
export function threeQuartersBits(bytes: Uint8Array): number {
  // The first falling edge is a true start bit.
  let places: readonly number[] = ONES.map((_, place) => (place === 0 ? 1 : 0));
  let bits = 0;
  for (const byte of bytes) {
    const fits = places.map((chance, place) => (chance === 0 ? 0 : chance * likelihood(byte, place)));
    const sum = fits.reduce((total, chance) => total + chance, 0);
    bits += Math.log2(sum) + BITS;
    places = following(
      fits.map((chance) => chance / sum),
      byte >> (BITS - 1),
    );
  }
  return bits;
}

/** The chance of a byte whose start bit was at this place. */
const likelihood = (byte: number, place: number): number =>
  SEEN.reduce((chance, at, index) => {
    const isOne = (byte >> index) & 1;
    return chance * (isOne ? one(place + at) : 1 - one(place + at));
  }, 1);

/** Where the next falling edge is: at a start bit at the latest. `last` is the bit that was seen just before. */
function following(places: readonly number[], last: number): number[] {
  const next = new Array<number>(ONES.length).fill(0);
  const add = (bit: number, chance: number) => {
    next[placeOf(bit)] = (next[placeOf(bit)] ?? 0) + chance;
  };
  places.forEach((chance, place) => {
    if (chance === 0) return;
    let left = chance;
    let before = last;
    let bit = place + NEXT;
    for (; bit % CHARACTER !== 0; bit++) {
      const falls = before * (1 - one(bit));
      add(bit, left * falls);
      left *= 1 - falls;
      before = one(bit) / (1 - falls);
    }
    add(bit, left);
  });
  return next;
}
