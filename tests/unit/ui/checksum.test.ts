import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { checksums, crcCatalogue } from '../../../src/modbus/index.ts';
import { readClaim } from '../../../src/ui/checksum/claim.ts';
import { wholeOf } from '../../../src/ui/checksum/digest-task.ts';
import { noOwn, ownTexts, powersOf, readOwn } from '../../../src/ui/checksum/own.ts';
import { readSort, rowOf, sorted, sortText } from '../../../src/ui/checksum/rows.ts';
import { finder } from '../../../src/ui/reference/search.ts';
import { hex } from '../modbus/frames.ts';

const row = (name: string) => crcCatalogue.find((one) => one.name === name)!;

describe('parameters as typed', () => {
  it('in decimal and hexadecimal, with the polynomial in each form', () => {
    const modbus = { ...noOwn, width: '16', init: '65535', refin: true, refout: true };
    for (const [poly, polyAs] of [
      ['0x8005', 'normal'],
      ['32773', 'normal'],
      ['A001h', 'reversed'],
      ['16#C002', 'koopman'],
    ] as const) {
      expect(readOwn({ ...modbus, poly, polyAs }).crc, poly).toMatchObject({ poly: 0x8005, check: 0x4b37, residue: 0 });
    }
  });

  it.each(crcCatalogue.map((one) => [one.name, one] as const))('%s: written and read', (_, one) => {
    const { name: _name, aliases: _aliases, ...parameters } = one;
    expect(readOwn(ownTexts(one)).crc).toMatchObject(parameters);
  });

  it('says what is wrong with each', () => {
    expect(readOwn(noOwn)).toEqual({ faults: {}, values: {} });
    expect(readOwn({ ...noOwn, width: '33', poly: '' }).faults).toEqual({
      width: { code: 'out-of-range', least: 1, most: 32 },
      poly: { code: 'missing' },
    });
    expect(readOwn({ ...noOwn, width: '8', poly: '0x100', init: 'A001', xorout: '-1' }).faults).toEqual({
      poly: { code: 'out-of-range', least: 0, most: 255 },
      init: { code: 'not-a-number', text: 'A001' },
      xorout: { code: 'out-of-range', least: 0, most: 255 },
    });
  });

  it('never throws', () => {
    fc.assert(
      fc.property(fc.string(), fc.string(), fc.string(), (width, poly, init) => {
        readOwn({ ...noOwn, width, poly, init });
        readClaim(poly);
      }),
    );
  });

  it('as powers of x', () => {
    expect(powersOf(row('CRC-16/MODBUS'))).toBe('x^16 + x^15 + x^2 + 1');
    expect(powersOf(row('CRC-8/SMBUS'))).toBe('x^8 + x^2 + x + 1');
  });
});

describe('a claimed value', () => {
  it.each([
    ['0x1AF3', ['1AF3']],
    ['1AF3', ['1AF3']],
    ['F3 1A', ['F31A']],
    ['6899', ['6899', '1AF3']],
    ['18', ['18', '12']],
    ['1AF3h', ['1AF3']],
    ['0x83E7A032', ['83E7A032']],
    ['12 34 56', []],
    ['x', []],
    ['', []],
  ])('%s', (text, claims) => {
    expect(readClaim(text)).toEqual(claims.map(hex));
  });
});

describe('the lines of the table', () => {
  const { values } = wholeOf('210303E70004', 'bytes');
  const rows = checksums.map((one) => rowOf(one, one.name, values[one.name]));
  const found = (search: string) => rows.filter(finder(search)).map(({ name }) => name);

  it('are found by name, value in either order, and polynomial', () => {
    expect(found('0x1AF3')).toEqual(['CRC-16/MODBUS']);
    expect(found('0xC278')).toEqual(['CRC-16/DNP']);
    expect(found('ca7a')).toEqual(['CRC-16/KERMIT']);
    expect(found('a001 ffff')).toEqual(expect.arrayContaining(['CRC-16/MODBUS', 'CRC-16/USB']));
    expect(found('ccitt')).toContain('CRC-16/KERMIT');
    // As a calculator on the web names it.
    expect(found('CRC-CCITT (0x1D0F)')).toEqual(['CRC-16/SPI-FUJITSU']);
    expect(found('zmodem')).toEqual(['CRC-16/XMODEM']);
  });

  it('stand in the order that is asked for, and the address says it', () => {
    const by = (text: string) => sorted(rows, readSort(text)).map(({ value }) => value!);
    expect(by('value')).toEqual(by('value').toSorted((a, b) => a - b));
    expect(by('-value')).toEqual(by('value').toReversed());
    expect(sorted(rows, readSort('nothing'))).toBe(rows);
    expect(sortText(readSort('-check'))).toBe('-check');
  });

  it('take text as it is', () => {
    expect(wholeOf('123456789', 'text').values['CRC-16/MODBUS']).toBe(0x4b37);
    expect(wholeOf('µ', 'text').reading.bytes).toEqual(hex('C2 B5'));
  });
});
