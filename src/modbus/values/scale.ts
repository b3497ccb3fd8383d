import { add, compare, divide, type Fraction, fraction, multiply, round, roundTo, subtract } from './fraction.ts';

/**
 * How a value in units stands in registers: raw = value × factor + offset. Numbers are exact, so that a factor can be
 * 8192/60. `decimals` is how many digits a value is shown with, `least` and `most` are its limits in units.
 */
export interface Scale {
  readonly factor: Fraction;
  readonly offset: Fraction;
  readonly decimals: number;
  readonly least?: Fraction | undefined;
  readonly most?: Fraction | undefined;
}

export type RawReading =
  | {
      readonly kind: 'raw';
      readonly raw: bigint;
      /** Whether the raw number stands for the very value; else `stands` is what it stands for. */
      readonly exact: boolean;
      readonly stands: Fraction;
    }
  | { readonly kind: 'outside-limits'; readonly least: Fraction | undefined; readonly most: Fraction | undefined };

/** The raw number for a value in units, exactly: whole only by chance. */
export const rawExactly = (value: Fraction, { factor, offset }: Pick<Scale, 'factor' | 'offset'>): Fraction =>
  add(multiply(value, factor), offset);

/** The value in units that a raw number stands for, exactly. A factor of 0 throws a `RangeError`. */
export const unitsExactly = (raw: Fraction, { factor, offset }: Pick<Scale, 'factor' | 'offset'>): Fraction =>
  divide(subtract(raw, offset), factor);

/** The raw number for a value in units: the nearest whole one, halves away from 0. Whether it fits a type is not asked. */
export function toRaw(value: Fraction, scale: Scale): RawReading {
  const { least, most } = scale;
  if (isOutside(value, scale)) return { kind: 'outside-limits', least, most };
  const exactly = rawExactly(value, scale);
  const raw = round(exactly);
  return {
    kind: 'raw',
    raw,
    exact: compare(exactly, fraction(raw)) === 0,
    stands: unitsExactly(fraction(raw), scale),
  };
}

/** What a raw number stands for. */
export interface ScaledReading {
  readonly exactly: Fraction;
  /** Rounded to the scale's decimals, halves away from 0. */
  readonly value: Fraction;
  readonly exact: boolean;
  readonly outside: boolean;
}

/** The value in units that a raw number stands for. A factor of 0 throws a `RangeError`. */
export function fromRaw(raw: Fraction, scale: Scale): ScaledReading {
  const exactly = unitsExactly(raw, scale);
  const value = roundTo(exactly, scale.decimals);
  return { exactly, value, exact: compare(exactly, value) === 0, outside: isOutside(exactly, scale) };
}

/** Whether a value in units is beyond the limits of its scale. */
export const isOutside = (value: Fraction, { least, most }: Scale): boolean =>
  (least !== undefined && compare(value, least) < 0) || (most !== undefined && compare(value, most) > 0);
