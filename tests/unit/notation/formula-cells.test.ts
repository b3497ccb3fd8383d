import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { readRegisterMap, readTable, writeTable } from '../../../src/devices/index.ts';
import { writeCsvFile } from '../../../src/notation/index.ts';

const textOf = (cell: string) => writeCsvFile([[cell]]).slice(0, -2);

describe('cells that a spreadsheet would run', () => {
  test.each(["=cmd|'/c calc'!A0", '@SUM(1)', '-2+3', '+1+1', '\tx', '=1', '-A1'])(
    '%j has an apostrophe before it',
    (cell) => {
      expect(textOf(cell).replace(/^"|"$/g, '').startsWith("'")).toBe(true);
    },
  );

  test.each(['-5', '+1', '-2.5', '1e-3', '-1e-3', '-', '', 'a=b', '30 °C'])('%j stays as it is', (cell) => {
    expect(textOf(cell)).toBe(cell);
  });

  test('any name of a register is read back as it was', () => {
    const name = fc.oneof(
      fc.string({ minLength: 1 }),
      fc.tuple(fc.constantFrom('=', '+', '-', '@', "'", "'=", "''-"), fc.string()).map((parts) => parts.join('')),
    );
    fc.assert(
      fc.property(name, (text) => {
        const wanted = text.replace(/[\r\n\t\uFEFF\0]/g, '').trim();
        fc.pre(wanted !== '');
        const profile = readTable(
          [
            ['#id', 'a'],
            ['#convention', 'zero-based'],
            ['#version', '2'],
            ['name', 'table', 'address'],
            ['x', 'hr', '1'],
          ].map((cells, index) => ({ line: index + 1, cells })),
          'a',
        ).profile;
        const [register] = profile.registers;
        if (!register) throw new Error('No register.');
        const named = { ...profile, registers: [{ ...register, name: wanted }] };
        const csv = writeCsvFile(writeTable(named));
        expect(readRegisterMap(csv).profile.registers.map((each) => each.name)).toEqual([wanted]);
      }),
    );
  });
});
