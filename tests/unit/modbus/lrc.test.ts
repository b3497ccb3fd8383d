import fc from 'fast-check';
import { expect, test } from 'vitest';
import { lrc } from '../../../src/modbus/index.ts';
import { hex } from './frames.ts';
import { summedLrc } from './reference.ts';

test.each([
  ['', 0x00],
  ['00', 0x00],
  ['01', 0xff],
  ['80 80', 0x00],
  ['0A 01 04 A1 00 01', 0x4f],
  ['11 03 00 6B 00 03', 0x7e],
  ['F7 03 13 89 00 0A', 0x60],
])('of %j is %i', (text, value) => {
  expect(lrc(hex(text))).toBe(value);
});

test('the sum with the LRC is zero, between any places', () => {
  fc.assert(
    fc.property(fc.uint8Array({ maxLength: 300 }), fc.nat(300), fc.nat(300), (bytes, a, b) => {
      const [from, to] = [Math.min(a, b, bytes.length), Math.min(Math.max(a, b), bytes.length)];
      const value = lrc(bytes, from, to);
      expect(value).toBe(summedLrc(bytes.subarray(from, to)));
      expect(lrc(Uint8Array.of(...bytes.subarray(from, to), value))).toBe(0);
    }),
    { numRuns: 500 },
  );
});

test('the bytes outside the places do not matter', () => {
  expect(lrc(hex('55 0A 01 04 A1 00 01 AA'), 1, 7)).toBe(0x4f);
  expect(lrc(hex('0A'), 1, 1)).toBe(0);
});
