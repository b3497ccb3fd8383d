// Conditions on arguments. To break one is a mistake in the calling program, so these functions throw.

/** Throws a `RangeError` unless the value is a whole number from `least` to `most`. */
export function demandWhole(what: string, value: number, least: number, most: number): void {
  if (!(Number.isInteger(value) && value >= least && value <= most)) {
    throw new RangeError(`${what}: ${value} is not a whole number from ${least} to ${most}`);
  }
}

/** Throws a `RangeError` unless `[from, to)` is a part of the bytes, perhaps an empty one. */
export function demandPart(bytes: Uint8Array, from: number, to: number): void {
  if (!(from >= 0 && to <= bytes.length && Number.isInteger(from) && Number.isInteger(to))) {
    throw new RangeError(`${bytes.length} bytes have no part from ${from} to ${to}`);
  }
}

/** Throws a `RangeError` for NaN and infinities. */
export function demandFinite(what: string, value: number): void {
  if (!Number.isFinite(value)) throw new RangeError(`${what}: ${value} is not finite`);
}

/** Throws a `RangeError` unless the value is a finite number from 0, or, if asked so, above 0. */
export function demandPositive(what: string, value: number, zero: 'or-zero' | 'not-zero'): void {
  if (!(Number.isFinite(value) && (zero === 'or-zero' ? value >= 0 : value > 0))) {
    throw new RangeError(`${what}: ${value} is not a finite number ${zero === 'or-zero' ? 'from' : 'above'} 0`);
  }
}
