import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { formatBinary, formatHex, readNumber } from '../../../src/notation/index.ts';

describe('one number, as people in the field write it', () => {
  test.each([
    ['683'],
    ['0683'],
    ['0x2AB'],
    ['0x02AB'],
    ['0X02ab'],
    ['2ABh'],
    ['02abH'],
    ['16#2AB'],
    ['16#02ab'],
    ['$2AB'],
    ['0b1010101011'],
    ['0B0000001010101011'],
    ['2#1010101011'],
    ['  683\t'],
    ['+683'],
    ['0b10_1010_1011'],
    ['0x02_AB'],
    ['16#2_A_B'],
  ])('%j is 683', (text) => {
    expect(readNumber(text)).toBe(683);
  });

  test('digits in groups', () => {
    expect(readNumber('1_000_000')).toBe(1000000);
    expect(readNumber('2#1111_0000')).toBe(0xf0);
  });

  test('what looks like hexadecimal is decimal without a sign of its base', () => {
    expect(readNumber('10')).toBe(10);
    expect(readNumber('10h')).toBe(16);
    expect(readNumber('0b1')).toBe(1);
    expect(readNumber('0b1h')).toBe(0xb1);
  });

  test('a sign and a fraction are read, for the answer to say what is wrong with them', () => {
    expect(readNumber('-1')).toBe(-1);
    expect(readNumber('−1')).toBe(-1);
    expect(readNumber('- 1')).toBe(-1);
    expect(readNumber('-0x10')).toBe(-16);
    expect(readNumber('1.5')).toBe(1.5);
    expect(readNumber('-1.5')).toBe(-1.5);
    expect(readNumber('70000')).toBe(70000);
  });

  test.each([
    '',
    '   ',
    'abc',
    '2AB',
    '0x',
    '0xG',
    'h',
    '$',
    '16#',
    '2#2',
    '0b2',
    '8#17',
    '12 34',
    '1,5',
    '1.',
    '.5',
    '1e3',
    '+-5',
    '--5',
    '_1',
    '1_',
    '1__0',
    'NaN',
    'Infinity',
    '0x1.5',
    '１',
  ])('%j is none', (text) => {
    expect(readNumber(text)).toBeUndefined();
  });
});

test('every 16-bit number is read back from each of its ways', () => {
  fc.assert(
    fc.property(fc.nat(0xffff), (value) => {
      const digits = value.toString(16).toUpperCase();
      const bits = value.toString(2);
      const ways = [String(value), `0x${digits}`, `${digits}h`, `16#${digits}`, `$${digits}`, `0b${bits}`, `2#${bits}`];
      for (const way of [...ways, formatHex(value, 4)]) expect(readNumber(way), way).toBe(value);
    }),
    { numRuns: 300 },
  );
});

test('no text makes it throw, and what it answers is a number', () => {
  fc.assert(
    fc.property(fc.oneof(fc.string(), fc.string({ unit: fc.constantFrom(...'0123abfhx#$._-+ ') })), (text) => {
      const value = readNumber(text);
      if (value !== undefined) expect(value).not.toBeNaN();
    }),
    { numRuns: 1000 },
  );
});

test('hexadecimal has 0x and at least so many digits', () => {
  expect(formatHex(683, 4)).toBe('0x02AB');
  expect(formatHex(3, 2)).toBe('0x03');
  expect(formatHex(0, 1)).toBe('0x0');
  expect(formatHex(0x12345, 4)).toBe('0x12345');
});

test('binary has groups of four, counted from the right', () => {
  expect(formatBinary(6, 8)).toBe('0000 0110');
  expect(formatBinary(0xffff, 16)).toBe('1111 1111 1111 1111');
  expect(formatBinary(5, 3)).toBe('101');
  expect(formatBinary(0x15, 5)).toBe('1 0101');
  expect(formatBinary(0x100, 8)).toBe('1 0000 0000');
});
