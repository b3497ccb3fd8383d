import { expect, it } from 'vitest';
import { writeNumberTable } from '../../../src/notation/index.ts';

const nine = [0x0000, 0xc0c1, 0xc181, 0x0140, 0xc301, 0x03c0, 0x0280, 0xc241, 0xc601];

it('writes an array in C, eight in a line', () => {
  expect(writeNumberTable('crc_table', nine, 16, 'c')).toBe(`static const uint16_t crc_table[9] = {
  0x0000, 0xC0C1, 0xC181, 0x0140, 0xC301, 0x03C0, 0x0280, 0xC241,
  0xC601
};`);
});

it('writes an array in Structured Text', () => {
  expect(writeNumberTable('crc_table', nine, 16, 'st')).toBe(`crc_table : ARRAY[0..8] OF WORD := [
  16#0000, 16#C0C1, 16#C181, 16#0140, 16#C301, 16#03C0, 16#0280, 16#C241,
  16#C601
];`);
});

it('takes the smallest type that has the bits', () => {
  const first = (bits: number) => writeNumberTable('t', [1], bits, 'c').split('\n').slice(0, 2).join('');
  expect(first(8)).toBe('static const uint8_t t[1] = {  0x01');
  expect(first(12)).toBe('static const uint16_t t[1] = {  0x001');
  expect(first(32)).toBe('static const uint32_t t[1] = {  0x00000001');
  expect(writeNumberTable('t', [1], 24, 'st')).toContain('OF DWORD := [\n  16#000001');
});
