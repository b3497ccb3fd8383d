import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { crc16 } from '../../../src/modbus/index.ts';
import { characters, hex } from './frames.ts';
import { bitwiseCrc } from './reference.ts';

describe('the register value', () => {
  test.each([
    ['', 0xffff],
    ['00', 0x40bf],
    ['02 07', 0x1241],
    ['11 03 00 6B 00 03', 0x8776],
    ['11 03 06 AE 41 56 52 43 40', 0xad49],
    ['11 05 00 AC FF 00', 0x8b4e],
    ['01 04 02 FF FF', 0x80b8],
  ])('of %j is %i', (text, value) => {
    expect(crc16(hex(text))).toBe(value);
  });

  test('of the digits 1 to 9 is the check value of the catalogues', () => {
    expect(crc16(characters('123456789'))).toBe(0x4b37);
  });
});

test('a frame with its CRC, low byte first, leaves zero, and so it does with any zeros behind', () => {
  const frame = hex('02 07 41 12');
  expect(crc16(frame)).toBe(0);
  expect(crc16(Uint8Array.of(...frame, 0, 0, 0))).toBe(0);
  // High byte first it does not.
  expect(crc16(hex('02 07 12 41'))).not.toBe(0);
});

test('every length around the eight bytes that are folded at a time, at every offset', () => {
  const bytes = Uint8Array.from({ length: 64 }, (_, i) => (i * 73 + 41) & 0xff);
  for (let from = 0; from <= 17; from++) {
    for (let to = from; to <= bytes.length; to++) {
      expect(crc16(bytes, from, to)).toBe(bitwiseCrc(bytes.subarray(from, to)));
    }
  }
});

test('any bytes between any places', () => {
  fc.assert(
    fc.property(fc.uint8Array({ maxLength: 300 }), fc.nat(300), fc.nat(300), (bytes, a, b) => {
      const [from, to] = [Math.min(a, b, bytes.length), Math.min(Math.max(a, b), bytes.length)];
      expect(crc16(bytes, from, to)).toBe(bitwiseCrc(bytes.subarray(from, to)));
      expect(crc16(bytes)).toBe(bitwiseCrc(bytes));
    }),
    { numRuns: 500 },
  );
});

test('the bytes outside the places do not matter', () => {
  expect(crc16(hex('55 02 07 AA'), 1, 3)).toBe(0x1241);
  expect(crc16(hex('02 07'), 1, 1)).toBe(0xffff);
});
