import fc from 'fast-check';
import { expect, test } from 'vitest';
import { fromHex } from '../../../src/modbus/index.ts';
import { formatBytes, readOctets } from '../../../src/notation/index.ts';

test('bytes are upper-case pairs with a blank between', () => {
  expect(formatBytes(new Uint8Array())).toBe('');
  expect(formatBytes(Uint8Array.of(6))).toBe('06');
  expect(formatBytes(Uint8Array.of(6, 6, 2, 0xab))).toBe('06 06 02 AB');
});

test('any bytes are read back, as bytes and as octets', () => {
  fc.assert(
    fc.property(fc.uint8Array({ maxLength: 300 }), (bytes) => {
      const text = formatBytes(bytes);
      expect(text).toHaveLength(Math.max(0, 3 * bytes.length - 1));
      expect(fromHex(text)).toEqual(bytes);
      expect(readOctets(text)).toBe(text.replaceAll(' ', ''));
    }),
    { numRuns: 200 },
  );
});

test.each([
  ['01 FF', '01FF'],
  ['01ff', '01FF'],
  ['0x01, 0xFF', '01FF'],
  ['0X01;0XFF', '01FF'],
  ['"PLC"', '504C43'],
  ['01 FF "PLC" 00', '01FF504C4300'],
  ['"01 FF"', '3031204646'],
  ['""', ''],
  ['', ''],
])('octets %j are %j', (text, pairs) => {
  expect(readOctets(text)).toBe(pairs);
});

test.each(['0', '012', 'XY', '"open', '"é"', '"a\nb"', "'a'", '01 "a" 2'])('octets %j are none', (text) => {
  expect(readOctets(text)).toBeUndefined();
});
