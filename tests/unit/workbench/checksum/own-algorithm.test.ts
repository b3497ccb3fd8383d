import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { crcCatalogue } from '../../../../src/modbus/index.ts';
import { noOwn, ownTexts, powersOf, readOwn } from '../../../../src/workbench/checksum/own-algorithm.ts';

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
      }),
    );
  });

  it('as powers of x', () => {
    expect(powersOf(row('CRC-16/MODBUS'))).toBe('x^16 + x^15 + x^2 + 1');
    expect(powersOf(row('CRC-8/SMBUS'))).toBe('x^8 + x^2 + x + 1');
  });
});
