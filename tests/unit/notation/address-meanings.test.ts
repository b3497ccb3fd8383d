import fc from 'fast-check';
import { describe, expect, it, test } from 'vitest';
import type { Table } from '../../../src/modbus/index.ts';
import {
  type AddressConvention,
  addressConventions,
  addressMeant,
  printedAddress,
  readAddress,
  sixDigitNumber,
  writeAddress,
  zeroBasedAddress,
} from '../../../src/notation/index.ts';

const written = (table: Table, address: number) =>
  Object.fromEntries(writeAddress(table, address).map(({ notation, text }) => [notation, text]));

describe('writing', () => {
  it('holding register 40108 is address 006B (PI ch. 2)', () => {
    expect(written('holding-register', 0x006b)).toEqual({
      decimal: '107',
      hex: '0x006B',
      number: '108',
      'five-digit': '40108',
      'six-digit': '400108',
      prefix: '4x108',
      letters: 'HR108',
      iec: '%MW107',
      'digit-from-zero': '40107',
    });
  });

  it('coil 1 is addressed as 0000 (PI ch. 2), coil 173 is 00AC', () => {
    expect(written('coil', 0)).toMatchObject({ 'five-digit': '00001', prefix: '0x1', letters: 'CO1', iec: '%QX0.0' });
    expect(written('coil', 0x00ac)).toMatchObject({ number: '173', 'six-digit': '000173', iec: '%QX21.4' });
  });

  it('discrete input 10197 and input register 30009 (PI fn 02, 04)', () => {
    expect(written('discrete-input', 0x00c4)).toMatchObject({
      'five-digit': '10197',
      letters: 'DI197',
      iec: '%IX24.4',
    });
    expect(written('input-register', 8)).toMatchObject({ 'five-digit': '30009', letters: 'IR9', iec: '%IW8' });
  });

  it('five digits end at number 9999, and addresses with a digit at 9999', () => {
    expect(written('holding-register', 9998)).toMatchObject({ 'five-digit': '49999', 'digit-from-zero': '49998' });
    expect(written('holding-register', 9999)).not.toHaveProperty('five-digit');
    expect(written('holding-register', 9999)).toMatchObject({ 'six-digit': '410000', 'digit-from-zero': '49999' });
    expect(written('holding-register', 65535)).toMatchObject({ 'six-digit': '465536', 'digit-from-zero': '465535' });
  });

  it('records of extended memory are counted from 0 (PI fn 20)', () => {
    expect(written('file-record', 107)).toEqual({
      decimal: '107',
      hex: '0x006B',
      'five-digit': '60107',
      'six-digit': '600107',
      prefix: '6x107',
    });
    expect(sixDigitNumber('file-record', 107)).toBe('600107');
    expect(printedAddress('one-based', 'file-record', 0)).toEqual(['0']);
    expect(readAddress('9', 'one-based', 'file-record').map(({ address }) => address)).toEqual([9]);
  });
});

describe('what names its table is understood by itself', () => {
  test.each([
    ['4x108', 'holding-register', 107],
    ['4:108', 'holding-register', 107],
    ['4X00108', 'holding-register', 107],
    ['400108', 'holding-register', 107],
    ['465536', 'holding-register', 65535],
    ['HR108', 'holding-register', 107],
    ['hr 108', 'holding-register', 107],
    ['HR:108', 'holding-register', 107],
    ['%MW107', 'holding-register', 107],
    ['%QW107', 'holding-register', 107],
    ['3x9', 'input-register', 8],
    ['IR9', 'input-register', 8],
    ['%IW8', 'input-register', 8],
    ['1x197', 'discrete-input', 196],
    ['DI197', 'discrete-input', 196],
    ['%IX24.4', 'discrete-input', 196],
    ['%IX196', 'discrete-input', 196],
    ['0:173', 'coil', 172],
    ['CO173', 'coil', 172],
    ['%QX21.4', 'coil', 172],
    ['%MX21.4', 'coil', 172],
    ['%M172', 'coil', 172],
    ['6x107', 'file-record', 107],
    ['600107', 'file-record', 107],
  ] as const)('%s is %s %i', (text, table, address) => {
    expect(addressMeant(text)).toMatchObject({ table, address });
    expect(zeroBasedAddress(text)).toBe(address);
  });

  test.each([
    '4x0',
    '4x65537',
    'HR',
    'HR0',
    '%MW65536',
    '%MW1.16',
    '%QX1.8',
    '%KW3',
    '5x1',
    '2:1',
    '4x1F',
    '4x',
    '%',
    '',
  ])('%s is not an address', (text) => {
    expect(readAddress(text)).toEqual([]);
    expect(zeroBasedAddress(text)).toBeUndefined();
  });
});

describe('what may be several things', () => {
  const meanings = (text: string, convention: AddressConvention, table: Table) =>
    readAddress(text, convention, table).map(({ table, address, notation }) => [notation, table, address]);

  it('40001 is address 40001 from 0, or register 1', () => {
    expect(meanings('40001', 'protocol', 'holding-register')).toEqual([
      ['decimal', 'holding-register', 40001],
      ['number', 'holding-register', 40000],
      ['five-digit', 'holding-register', 0],
      ['digit-from-zero', 'holding-register', 1],
    ]);
    expect(meanings('40001', 'digits', 'holding-register')[0]).toEqual(['five-digit', 'holding-register', 0]);
    expect(meanings('40001', 'one-based', 'holding-register')[0]).toEqual(['number', 'holding-register', 40000]);
    expect(meanings('40001', 'digit-from-zero', 'holding-register')[0]).toEqual([
      'digit-from-zero',
      'holding-register',
      1,
    ]);
  });

  it('0x108 is hexadecimal or coil 108, and only for coils both', () => {
    expect(meanings('0x108', 'protocol', 'coil')).toEqual([
      ['hex', 'coil', 0x108],
      ['prefix', 'coil', 107],
    ]);
    expect(meanings('0x108', 'digits', 'coil')[0]).toEqual(['prefix', 'coil', 107]);
    expect(meanings('0x108', 'digits', 'holding-register')).toEqual([['hex', 'holding-register', 0x108]]);
    expect(meanings('0x6B', 'digits', 'coil')).toEqual([['hex', 'coil', 107]]);
  });

  it('00108 is 108 or coil 108', () => {
    expect(meanings('00108', 'protocol', 'coil').slice(0, 3)).toEqual([
      ['decimal', 'coil', 108],
      ['number', 'coil', 107],
      ['five-digit', 'coil', 107],
    ]);
    expect(meanings('00108', 'protocol', 'holding-register')).toEqual([
      ['decimal', 'holding-register', 108],
      ['number', 'holding-register', 107],
    ]);
  });

  it('counts from 0 in hexadecimal whatever the manual does', () => {
    for (const convention of addressConventions) {
      for (const text of ['0x6B', '6Bh', '16#6B', '$6B', '0b1101011'])
        expect(addressMeant(text, convention, 'holding-register')?.address).toBe(107);
    }
  });

  it('is nothing beyond the last address', () => {
    expect(zeroBasedAddress('65536')).toBe(65536);
    expect(addressMeant('65536')).toBeUndefined();
    expect(addressMeant('65536', 'one-based')?.address).toBe(65535);
    // As hexadecimal it is too large; the field of a frame does not take it for a coil by itself.
    expect(addressMeant('0x10000', 'protocol', 'coil')).toBeUndefined();
    expect(zeroBasedAddress('-1')).toBe(-1);
    expect(zeroBasedAddress('1.5')).toBe(1.5);
  });
});

test('any text has addresses in range, and both readers agree on it', () => {
  const text = fc.oneof(
    fc.string(),
    fc.stringMatching(/^[0134 6%xHRCODIQMWX:.#h]{0,8}$/),
    fc.stringMatching(/^(0x|4x|%MX|HR)?\d{1,7}$/),
  );
  fc.assert(
    fc.property(text, fc.constantFrom(...addressConventions), (typed, convention) => {
      for (const { address } of readAddress(typed, convention)) {
        expect(Number.isInteger(address) && address >= 0 && address <= 65535).toBe(true);
      }
      const meant = addressMeant(typed)?.address;
      const light = zeroBasedAddress(typed);
      const valid = light !== undefined && Number.isInteger(light) && light >= 0 && light <= 65535;
      expect(meant === undefined ? undefined : meant + 0).toBe(valid ? light + 0 : undefined);
    }),
  );
});
