import { readFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { crc, crc16, crcCatalogue, lrc, sum8, xor8 } from '../../../src/modbus/index.ts';
import { characters, hex } from './frames.ts';

interface Row {
  readonly name: string;
  readonly aliases: readonly string[];
  readonly width: number;
  readonly poly: string;
  readonly init: string;
  readonly refin: boolean;
  readonly refout: boolean;
  readonly xorout: string;
  readonly check: string;
  readonly residue: string;
}

const { crc: published } = JSON.parse(
  readFileSync(new URL('../../vectors/crc-catalogue.json', import.meta.url), 'utf8'),
) as { crc: readonly Row[] };

const checkInput = characters('123456789');
const rows = crcCatalogue.map((row) => [row.name, row] as const);

describe('the catalogue', () => {
  it('has the rows of the published one', () => {
    const expected = published.map(({ name, aliases, width, poly, init, refin, refout, xorout, check, residue }) => ({
      name,
      aliases,
      width,
      poly: Number(poly),
      init: Number(init),
      refin,
      refout,
      xorout: Number(xorout),
      check: Number(check),
      residue: Number(residue),
    }));
    expect(crcCatalogue).toEqual(expected);
    expect(crcCatalogue).toHaveLength(63);
  });

  it.each(rows)('%s: the CRC of 123456789', (_, row) => {
    expect(crc(row, checkInput)).toBe(row.check);
  });

  it.each(rows)('%s: the register after a message and its CRC', (_, row) => {
    const size = row.width / 8;
    // Reflected ones are sent low byte first, the others high byte first.
    const sent = Array.from({ length: size }, (_, i) => (row.check >>> (8 * (row.refout ? i : size - 1 - i))) & 0xff);
    const after = crc({ ...row, xorout: 0 }, Uint8Array.of(...checkInput, ...sent));
    expect(after).toBe(row.residue);
  });
});

describe('parameters of one’s own', () => {
  it('takes widths that are no whole bytes', () => {
    // CRC-5/USB and CRC-12/UMTS of the RevEng catalogue.
    const usb = { width: 5, poly: 0x05, init: 0x1f, refin: true, refout: true, xorout: 0x1f };
    const umts = { width: 12, poly: 0x80f, init: 0, refin: false, refout: true, xorout: 0 };
    expect(crc(usb, checkInput)).toBe(0x19);
    expect(crc(umts, checkInput)).toBe(0xdaf);
  });

  it('takes a part of the bytes', () => {
    const modbus = crcCatalogue.find(({ name }) => name === 'CRC-16/MODBUS')!;
    expect(crc(modbus, hex('FF 02 07 41 12'), 1, 3)).toBe(0x1241);
  });

  it('is CRC-16/MODBUS where the other function is', () => {
    const modbus = crcCatalogue.find(({ name }) => name === 'CRC-16/MODBUS')!;
    fc.assert(fc.property(fc.uint8Array({ maxLength: 40 }), (bytes) => crc(modbus, bytes) === crc16(bytes)));
  });

  it.each([0, 33, 2.5, Number.NaN])('refuses a width of %s', (width) => {
    const row = { width, poly: 1, init: 0, refin: false, refout: false, xorout: 0 };
    expect(() => crc(row, checkInput)).toThrow(RangeError);
  });
});

describe('sums', () => {
  it('have their published check values', () => {
    expect(lrc(checkInput)).toBe(0x23);
    expect(sum8(checkInput)).toBe(0xdd);
    expect(xor8(checkInput)).toBe(0x31);
  });

  it('take a part of the bytes', () => {
    expect(sum8(hex('FF 80 81 FF'), 1, 3)).toBe(0x01);
    expect(xor8(hex('FF 80 81 FF'), 1, 3)).toBe(0x01);
  });
});
