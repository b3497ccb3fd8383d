import { expect, test } from 'vitest';
import { bitsOfBytes, bytesOfBits, withCount } from '../../../../src/workbench/index.ts';

// AP 6.11: ten coils from coil 20 on, bytes CD 01; the specification prints the bits of each byte with the highest first.
const TEN = [1, 0, 1, 1, 0, 0, 1, 1, 1, 0];

test('bits become the bytes that the specification prints', () => {
  expect(bytesOfBits(TEN)).toEqual(Uint8Array.of(0xcd, 0x01));
  expect(bytesOfBits([])).toEqual(new Uint8Array(0));
  // As the bytes are printed, without turning them round.
  expect(bytesOfBits([1, 1, 0, 0, 1, 1, 0, 1, 0, 0])).toEqual(Uint8Array.of(0xb3, 0x00));
});

test('bytes become bits, as many as there were where the bytes have room for them', () => {
  expect(bitsOfBytes('CD 01', 10)).toEqual(TEN);
  expect(bitsOfBytes('cd01', 16)).toEqual([...TEN, 0, 0, 0, 0, 0, 0]);
  // AP 6.1: 19 coils, CD 6B 05.
  expect(bitsOfBytes('CD 6B 05', 19)).toEqual([1, 0, 1, 1, 0, 0, 1, 1, 1, 1, 0, 1, 0, 1, 1, 0, 1, 0, 1]);
});

test('no bit of bytes is lost', () => {
  expect(bitsOfBytes('CD 05', 10)).toHaveLength(16);
  expect(bitsOfBytes('CD', 10)).toHaveLength(8);
  expect(bitsOfBytes('CD 01 00', 10)).toHaveLength(24);
  expect(bitsOfBytes('CD 0', 10)).toBeUndefined();
});

test('a number of bits keeps those that are there', () => {
  expect(withCount([1, 1], 4)).toEqual([1, 1, 0, 0]);
  expect(withCount([1, 0, 1], 2)).toEqual([1, 0]);
  expect(withCount([1], Number.NaN)).toEqual([1]);
  expect(withCount([1], 9999)).toHaveLength(2000);
});
