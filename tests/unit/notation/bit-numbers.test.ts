import fc from 'fast-check';
import { expect, test } from 'vitest';
import { formatBitNumbers, readBitNumbers } from '../../../src/notation/index.ts';

test.each([
  ['0, 3, 8-11', 0x0f09],
  ['15', 0x8000],
  ['11 - 8;0', 0x0f01],
  ['0–15', 0xffff],
  ['', 0],
])('%j', (text, mask) => {
  expect(readBitNumbers(text)).toEqual({ kind: 'bits', mask });
});

test('what is not a bit of a register', () => {
  for (const word of ['16', '-1', '0x1', '1-16', 'run', '1-2-3']) {
    expect(readBitNumbers(`0, ${word}`), word).toMatchObject({ kind: 'wrong' });
  }
});

test('every mask is written so that it is read back', () => {
  expect(formatBitNumbers(0x0f0b)).toBe('0, 1, 3, 8-11');
  fc.assert(
    fc.property(fc.nat(0xffff), (mask) => {
      expect(readBitNumbers(formatBitNumbers(mask))).toEqual({ kind: 'bits', mask });
    }),
  );
});
