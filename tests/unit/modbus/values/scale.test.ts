import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  compare,
  formatFraction,
  fraction,
  fromRaw,
  roundTo,
  type Scale,
  simplestFraction,
  toNumber,
  toRaw,
} from '../../../../src/modbus/index.ts';

/** A drive whose 8192 stands for 60 Hz. */
const drive: Scale = {
  factor: fraction(60, 8192),
  offset: fraction(0),
  decimals: 1,
  least: fraction(0),
  most: fraction(60),
};

describe('a drive at 8192 full scale of 60 Hz', () => {
  test.each([
    [0, 0n],
    [15, 2048n],
    [30, 4096n],
    [45, 6144n],
    [60, 8192n],
  ])('%d Hz', (hertz, raw) => {
    const stands = { kind: 'raw', raw, exact: true, stands: fraction(hertz) };
    expect(toRaw(fraction(hertz), drive)).toEqual(stands);
    expect(fromRaw(fraction(raw), drive)).toEqual({
      exactly: fraction(hertz),
      value: fraction(hertz),
      exact: true,
      outside: false,
    });
  });

  test('what is not exact says what it stands for', () => {
    // 50 Hz would be 6826.67; 6827 stands for 50.0024… Hz.
    expect(toRaw(fraction(50), drive)).toEqual({
      kind: 'raw',
      raw: 6827n,
      exact: false,
      stands: fraction(6827 * 60, 8192),
    });
    const back = fromRaw(fraction(6827), drive);
    expect(back.exact).toBe(false);
    expect(formatFraction(back.exactly, 4)).toBe('50.0024');
    expect(formatFraction(back.value, 1)).toBe('50.0');
  });

  test('limits', () => {
    expect(toRaw(fraction(61), drive)).toMatchObject({ kind: 'outside-limits', most: fraction(60) });
    expect(toRaw(fraction(-1, 10), drive)).toMatchObject({ kind: 'outside-limits' });
    expect(fromRaw(fraction(8193), drive).outside).toBe(true);
  });
});

test('an offset, and tenths', () => {
  // Tenths of a degree, 400 for 0 °C: 21.5 °C is 615.
  const degrees: Scale = { factor: fraction(1, 10), offset: fraction(-40), decimals: 1 };
  expect(toRaw(fraction(43, 2), degrees)).toMatchObject({ raw: 615n, exact: true });
  expect(toRaw(fraction(-401, 10), degrees)).toMatchObject({ raw: -1n, exact: true });
  expect(formatFraction(fromRaw(fraction(615), degrees).value, 1)).toBe('21.5');
});

test('halves are rounded away from 0', () => {
  const whole: Scale = { factor: fraction(1), offset: fraction(0), decimals: 0 };
  expect(toRaw(fraction(5, 2), whole)).toMatchObject({ raw: 3n });
  expect(toRaw(fraction(-5, 2), whole)).toMatchObject({ raw: -3n });
  expect(toRaw(fraction(49, 20), whole)).toMatchObject({ raw: 2n });
  expect(formatFraction(fraction(-1, 20), 1)).toBe('-0.1');
  expect(formatFraction(fraction(-1, 21), 1)).toBe('0.0');
  expect(formatFraction(fraction(1, 3), 5)).toBe('0.33333');
  expect(roundTo(fraction(2, 3), 2)).toEqual(fraction(67, 100));
  expect(() => fraction(1, 0)).toThrow(RangeError);
});

test('every raw number stands for a value that gives it again', () => {
  const scales = fc.record({
    factor: fc.tuple(fc.integer({ min: 1, max: 100_000 }), fc.integer({ min: 1, max: 100_000 })),
    offset: fc.integer(),
  });
  fc.assert(
    fc.property(fc.bigInt(-(2n ** 63n), 2n ** 64n), scales, (raw, { factor, offset }) => {
      const scale: Scale = { factor: fraction(...factor), offset: fraction(offset), decimals: 3 };
      const { exactly } = fromRaw(fraction(raw), scale);
      const again = toRaw(exactly, scale);
      expect(again).toMatchObject({ kind: 'raw', raw, exact: true });
      expect(again.kind === 'raw' && compare(again.stands, exactly)).toBe(0);
    }),
  );
});

test('the simplest fraction that a double may have been meant as', () => {
  expect(simplestFraction(8192 / 60)).toEqual(fraction(2048, 15));
  expect(simplestFraction(0.1)).toEqual(fraction(1, 10));
  expect(simplestFraction(-1.25)).toEqual(fraction(-5, 4));
  expect(simplestFraction(0)).toEqual(fraction(0));
  expect(simplestFraction(1e21)).toEqual(fraction(10n ** 21n));
  expect(() => simplestFraction(Number.NaN)).toThrow(RangeError);
});

test('a double as a fraction is the double again', () => {
  fc.assert(
    fc.property(fc.double({ noNaN: true, noDefaultInfinity: true }), (value) => {
      // -0 is 0.
      expect(toNumber(simplestFraction(value))).toBe(value + 0);
    }),
    { numRuns: 500 },
  );
  expect(toNumber(fraction(1, 3))).toBe(1 / 3);
  expect(toNumber(fraction(10n ** 400n))).toBe(Infinity);
  // Half between two doubles: to the even one.
  expect(toNumber(fraction(2n ** 53n + 1n))).toBe(2 ** 53);
});
