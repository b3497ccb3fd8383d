import { add, compare, divide, type Fraction, fraction, multiply, round, roundTo, subtract } from './fraction.ts';

/**
 * What a number in registers stands for: value = raw × factor + offset. Numbers are exact, so that a factor can be
 * 60/8192. `decimals` is how many digits a value is shown with, `least` and `most` are its limits in units.
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

/** The raw number for a value in units, exactly: whole only by chance. A factor of 0 throws a `RangeError`. */
export const rawExactly = (value: Fraction, { factor, offset }: Pick<Scale, 'factor' | 'offset'>): Fraction =>
  divide(subtract(value, offset), factor);

/** The value in units that a raw number stands for, exactly. */
export const unitsExactly = (raw: Fraction, { factor, offset }: Pick<Scale, 'factor' | 'offset'>): Fraction =>
  add(multiply(raw, factor), offset);

/**
 * The scale of raw = value × factor + offset, which is how some manuals say it: 8192/60 where 60 Hz are 8192. A factor of 0
 * throws a `RangeError`.
 */
export const inverseScale = <T extends Pick<Scale, 'factor' | 'offset'>>(scale: T): T => ({
  ...scale,
  factor: divide(fraction(1), scale.factor),
  offset: divide(subtract(fraction(0), scale.offset), scale.factor),
});

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

/** The value in units that a raw number stands for. */
export function fromRaw(raw: Fraction, scale: Scale): ScaledReading {
  const exactly = unitsExactly(raw, scale);
  const value = roundTo(exactly, scale.decimals);
  return { exactly, value, exact: compare(exactly, value) === 0, outside: isOutside(exactly, scale) };
}

/** Whether a value in units is beyond the limits of its scale. */
export const isOutside = (value: Fraction, { least, most }: Scale): boolean =>
  (least !== undefined && compare(value, least) < 0) || (most !== undefined && compare(value, most) > 0);
