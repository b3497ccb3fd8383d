import fc from 'fast-check';
import { expect, test } from 'vitest';
import { builtInProfiles, plainRegister } from '../../../../src/devices/index.ts';
import { parseCsv } from '../../../../src/ui/parts/csv.ts';
import { csvRows, readProfileCsv, writeProfileCsv } from '../../../../src/workbench/devices/profile-csv.ts';

const readCsv = (text: string, name: string) => readProfileCsv(text, name, parseCsv);

const names = (text: string) => readCsv(text, 'file').profile.registers.map(({ name }) => name);

test('semicolons with decimal commas, tabs, a BOM, quotes and line ends of any kind', () => {
  expect(readCsv('\uFEFFname;table;address;factor\r\nSpeed;holding;681;136,5\r\n', 'Drive')).toMatchObject({
    profile: { name: 'Drive', registers: [{ name: 'Speed', address: 681, factor: 136.5 }] },
    faults: [],
  });
  expect(names('name\ttable\taddress\nA, or B\tcoil\t1\n')).toEqual(['A, or B']);
  expect(names('"name","table","address","description"\r"Say ""on""",coil,1,"two\nlines"\rB,coil,2,')).toEqual([
    'Say "on"',
    'B',
  ]);
});

test('a fault names the line of the text, also after cells of several lines', () => {
  const text =
    '#note,"first\nsecond\nthird"\nname,table,address,description\nA,coil,1,"x\r\ny"\n\nB,coil,nine,\nC,coil,3,\n';
  const { profile, faults } = readCsv(text, 'file');
  expect(profile.registers.map(({ name }) => name)).toEqual(['A', 'C']);
  expect(faults).toEqual([{ code: 'cell-not-a-number', column: 'address', got: 'nine', line: 8 }]);
});

test('a quote that is never closed costs its own line alone', () => {
  const { profile, faults } = readCsv('name,table,address\nA,coil,1\n"B,coil,2\nC,coil,3\nD,coil,x\n', 'file');
  expect(profile.registers.map(({ name }) => name)).toEqual(['A', 'C']);
  expect(faults).toEqual([
    { code: 'quote-open', line: 3 },
    { code: 'cell-not-a-number', column: 'address', got: 'x', line: 5 },
  ]);
});

test('what is no table says that its headers are missing', () => {
  for (const text of ['', '\n\n', 'hello', '06 06 02 AB 10 00 F5 E5', '"', '{"a": 1}']) {
    expect(readCsv(text, 'file')).toMatchObject({ profile: { registers: [] } });
    expect(readCsv(text, 'file').faults.map(({ code }) => code)).toContain('header-missing');
  }
});

test('the built-in profiles survive as CSV, and so do texts of any characters', () => {
  for (const profile of builtInProfiles)
    expect(readCsv(writeProfileCsv(profile), 'file')).toEqual({ profile, faults: [] });
  const base = { id: '', name: 'A', source: '', convention: 'zero-based', traits: [], notes: [] } as const;
  const text = fc
    .array(fc.constantFrom(...',;|\t"\n\r\'#=\\é1aA '), { maxLength: 12 })
    .map((characters) => characters.join('').trim());
  fc.assert(
    fc.property(text, text, (description, unit) => {
      const line = { ...plainRegister, name: 'B', table: 'coil', type: 'bits', address: 0, description, unit } as const;
      const profile = { ...base, registers: [line] };
      expect(readCsv(writeProfileCsv(profile), 'file')).toEqual({ profile, faults: [] });
    }),
  );
});

test('any text has rows in the order of its lines', () => {
  fc.assert(
    fc.property(fc.array(fc.constantFrom('a', '"', ',', '\n', '\r\n'), { maxLength: 60 }), (parts) => {
      const lines = csvRows(parts.join(''), ',', parseCsv).map(({ line }) => line);
      expect(lines).toEqual(lines.toSorted((a, b) => a - b));
      expect(new Set(lines).size).toBe(lines.length);
    }),
  );
});
