import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  type CrcAlgorithm,
  checksum,
  checksums,
  crc,
  crcAdd,
  crcCatalogue,
  crcStart,
  crcValue,
  ownCrc,
  polynomialForms,
} from '../../../src/modbus/index.ts';
import { characters, hex } from './frames.ts';

const rows = crcCatalogue.map((row) => [row.name, row] as const);
const named = (name: string) => checksums.find((one) => one.name === name)!;

/** A CRC bit by bit over a list of bits, in big numbers: a second opinion that shares nothing with the tables. */
function bitwise({ width, poly, init, refin, refout, xorout }: CrcAlgorithm, bytes: Uint8Array): number {
  const top = 1n << BigInt(width);
  let register = BigInt(init);
  for (const byte of bytes) {
    const bits = byte.toString(2).padStart(8, '0').split('');
    for (const bit of refin ? bits.reverse() : bits) {
      register = (register << 1n) ^ (BigInt(bit) << BigInt(width));
      if (register & top) register ^= top | BigInt(poly);
    }
  }
  const digits = register.toString(2).padStart(width, '0');
  return Number(BigInt(`0b${refout ? [...digits].reverse().join('') : digits}`) ^ BigInt(xorout));
}

describe('the tables against single bits, for every row', () => {
  const random = (size: number, seed: number) =>
    Uint8Array.from({ length: size }, (_, i) => (i * seed + (i >> 3)) & 0xff);

  it.each(rows)('%s', (_, row) => {
    fc.assert(
      fc.property(fc.uint8Array({ maxLength: 40 }), (bytes) => crc(row, bytes) === bitwise(row, bytes)),
      { numRuns: 30 },
    );
    // Long enough for eight bytes at a time, with some left over, from an odd place.
    const long = random(2061, 73);
    expect(crc(row, long)).toBe(bitwise(row, long));
    expect(crc(row, long, 3, 2058)).toBe(bitwise(row, long.subarray(3, 2058)));
  });

  it('any parameters of up to 32 bits', () => {
    const parameters = fc.integer({ min: 1, max: 32 }).chain((width) => {
      const value = fc.integer({ min: 0, max: 2 ** width - 1 });
      return fc.record({
        width: fc.constant(width),
        poly: value,
        init: value,
        xorout: value,
        refin: fc.boolean(),
        refout: fc.boolean(),
      });
    });
    fc.assert(
      fc.property(parameters, fc.uint8Array({ maxLength: 20 }), (row, bytes) => {
        expect(crc(row, bytes)).toBe(bitwise(row, bytes));
      }),
    );
  });
});

describe('bytes in pieces', () => {
  it.each(checksums.map((one) => [one.name, one] as const))('%s: as in one piece', (_, one) => {
    expect(checksum(one, characters('123456789'))).toBe(one.check);
    fc.assert(
      fc.property(fc.uint8Array({ maxLength: 300 }), fc.nat(300), fc.nat(300), (bytes, a, b) => {
        const [first, second] = [Math.min(a, b, bytes.length), Math.min(Math.max(a, b), bytes.length)];
        let state = one.add(one.start, bytes, 0, first);
        state = one.add(state, bytes.subarray(first, second));
        expect(one.value(one.add(state, bytes, second))).toBe(checksum(one, bytes));
      }),
      { numRuns: 50 },
    );
  });

  it.each(checksums.filter(({ join }) => join).map((one) => [one.name, one] as const))('%s: side by side', (_, one) => {
    fc.assert(
      fc.property(fc.uint8Array({ maxLength: 40 }), fc.uint8Array({ maxLength: 40 }), (first, second) => {
        const joined = one.join!(one.add(one.start, first), one.add(0, second), second.length);
        expect(one.value(joined)).toBe(checksum(one, Uint8Array.of(...first, ...second)));
      }),
      { numRuns: 30 },
    );
  });

  it('a CRC goes on from its register', () => {
    const row = crcCatalogue.find(({ name }) => name === 'CRC-32/ISO-HDLC')!;
    const register = crcAdd(row, crcStart(row), characters('12345'));
    expect(crcValue(row, crcAdd(row, register, characters('6789')))).toBe(0xcbf43926);
  });
});

describe('the results that a calculator on the web shows for 21 03 03 E7 00 04', () => {
  const bytes = hex('21 03 03 E7 00 04');
  it.each([
    ['CRC-16/ARC', 0x01f3],
    ['CRC-16/MODBUS', 0x1af3],
    ['CRC-16/XMODEM', 0x6083],
    ['CRC-16/IBM-3740', 0x6e93],
    ['CRC-16/SPI-FUJITSU', 0x51bd],
    ['CRC-32/ISO-HDLC', 0x83e7a032],
    // It prints these three with their bytes swapped: 0xCA7A, 0xC278 and 0x9ACD.
    ['CRC-16/KERMIT', 0x7aca],
    ['CRC-16/DNP', 0x78c2],
    ['Sick', 0xcd9a],
    // In decimal: 18.
    ['SUM-8', 18],
  ])('%s', (name, value) => {
    expect(checksum(named(name), bytes)).toBe(value);
  });
});

describe('sums', () => {
  it('of the example of the specification', () => {
    expect(checksum(named('LRC'), hex('0A 01 04 A1 00 01'))).toBe(0x4f);
  });

  it('are those of the single bytes, at every place and length', () => {
    const bytes = Uint8Array.from({ length: 1100 }, (_, i) => 255 - (i % 7));
    for (const [from, to] of [
      [0, 1100],
      [1, 1100],
      [3, 3],
      [5, 7],
      [2, 1099],
      [1099, 1100],
    ] as const) {
      const sum = bytes.subarray(from, to).reduce((total, byte) => total + byte, 0);
      expect(checksum(named('SUM-8'), bytes, from, to)).toBe(sum % 256);
      expect(checksum(named('SUM-8'), bytes.subarray(1), Math.max(0, from - 1), to - 1)).toBe(
        bytes.subarray(Math.max(1, from), to).reduce((total, byte) => total + byte, 0) % 256,
      );
    }
  });
});

describe('parameters as a row', () => {
  it.each(rows)('%s: check and residue follow from the parameters', (name, row) => {
    const { width, poly, init, refin, refout, xorout } = row;
    const { check, residue } = ownCrc(name, { width, poly, init, refin, refout, xorout });
    expect([check, residue]).toEqual([row.check, row.residue]);
  });
});

it('a polynomial in each way it is printed', () => {
  const forms = (name: string) => polynomialForms(crcCatalogue.find((row) => row.name === name)!);
  expect(forms('CRC-16/MODBUS')).toEqual({ normal: 0x8005, reversed: 0xa001, koopman: 0xc002 });
  expect(forms('CRC-16/XMODEM')).toEqual({ normal: 0x1021, reversed: 0x8408, koopman: 0x8810 });
  expect(forms('CRC-32/ISO-HDLC')).toEqual({ normal: 0x04c11db7, reversed: 0xedb88320, koopman: 0x82608edb });
  expect(forms('CRC-8/SMBUS')).toEqual({ normal: 0x07, reversed: 0xe0, koopman: 0x83 });
});
