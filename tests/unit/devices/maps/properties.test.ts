import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { readMap, readRegisterMap, readSheets } from '../../../../src/devices/maps/index.ts';

const headers = {
  name: ['Name', 'Bezeichnung', 'Désignation', 'Nombre', 'Nome', 'Naam', 'Nazwa', '名称'],
  table: ['Table', 'Tabelle', 'Zone mémoire', 'Área de memoria', 'Tipo di registro', 'Soort', 'Obszar', '寄存器类型'],
  address: ['Address', 'Adresse', 'Adresse Modbus', 'Dirección', 'Indirizzo', 'Adres', 'Adres rejestru', '地址'],
  type: [
    'Data type',
    'Datentyp',
    'Type de donnée',
    'Tipo de dato',
    'Tipo di dato',
    'Gegevenstype',
    'Typ danych',
    '数据类型',
  ],
  factor: ['Factor', 'Faktor', 'Facteur', 'Factor de escala', 'Fattore', 'Schaalfactor', 'Mnożnik', '比例系数'],
  unit: ['Unit', 'Einheit', 'Unité', 'Unidad', 'Unità di misura', 'Eenheid', 'Jednostka', '单位'],
  access: ['Access', 'Zugriff', 'Accès', 'Acceso', 'Accesso', 'Toegang', 'Dostęp', '读写'],
} as const;
type Column = keyof typeof headers;
const columns = Object.keys(headers) as Column[];

const rows = fc.uniqueArray(
  fc.record({
    address: fc.integer({ min: 0, max: 29_999 }),
    type: fc.constantFrom('u16', 'i16', 'u32', 'f32'),
    table: fc.constantFrom('holding', 'input'),
    factor: fc.constantFrom('0.1', '0.01', '', '1/10'),
    unit: fc.constantFrom('V', 'A', '°C', 'kW'),
    access: fc.constantFrom('R', 'R/W'),
  }),
  { minLength: 3, maxLength: 20, selector: ({ address }) => address },
);
type Row = { readonly address: number } & Readonly<Record<Exclude<Column, 'name' | 'address'>, string>>;

const cellOf = (row: Row, place: number, column: Column): string =>
  column === 'name' ? `Value ${String.fromCharCode(65 + place)}` : String(row[column]);

function written(list: readonly Row[], order: readonly Column[], language: number, delimiter: string): string {
  const lines = [
    order.map((column) => headers[column][language]),
    ...list.map((row, place) => order.map((column) => cellOf(row, place, column))),
  ];
  return lines.map((cells) => cells.join(delimiter)).join('\r\n');
}

/** Every row of the source that is not blank, with what became of it. */
function fateCounts(source: string | Uint8Array) {
  const { sheets } = readSheets(source);
  const read = readMap(sheets, {});
  return sheets.map((sheet, at) => {
    const filled = sheet.rows.filter(({ cells }) => cells.some((cell) => cell.trim() !== ''));
    return { filled: filled.map(({ line }) => line), fates: read.fates[at] ?? new Map(), read };
  });
}

const cell = fc.oneof(
  fc.constantFrom(
    '40001',
    '0x10',
    '0064',
    '1.000',
    '40001.3',
    '-',
    '',
    'U16',
    'float',
    'R/W',
    'Input',
    '4',
    '0=Off; 1=On',
    '1/10',
    '°C',
    'Name',
    'Address',
    'Holding registers',
    '#note',
    '3 = three',
    'bit 4',
    '100-110',
    '"',
  ),
  fc.string({ maxLength: 8 }),
);
const anyTable = fc
  .array(
    fc.array(cell, { minLength: 1, maxLength: 6 }).map((cells) => cells.join(',')),
    { maxLength: 12 },
  )
  .map((lines) => lines.join('\n'));

describe('a register map', () => {
  it('is read to the same profile with other headers, another order of columns and another delimiter', () => {
    fc.assert(
      fc.property(
        rows,
        fc.shuffledSubarray(columns, { minLength: columns.length }),
        fc.integer({ min: 0, max: 7 }),
        fc.constantFrom(',', ';', '\t'),
        (list, order, language, delimiter) => {
          const expected = readRegisterMap(written(list, columns, 0, ','));
          const got = readRegisterMap(written(list, order, language, delimiter));
          expect(got.profile).toEqual(expected.profile);
          expect(got.profile.registers).toHaveLength(list.length);
          expect(got.faults).toEqual([]);
        },
      ),
      { numRuns: 60 },
    );
  });

  it('gives every row a fate, and names every row that is no register', () => {
    fc.assert(
      fc.property(anyTable, (text) => {
        for (const { filled, fates, read } of fateCounts(text)) {
          expect([...fates.keys()].sort((a, b) => a - b)).toEqual([...new Set(filled)].sort((a, b) => a - b));
          const told = new Set([...read.faults, ...read.notices].flatMap((one) => one.rows));
          for (const [line, fate] of fates)
            if (fate === 'fault' || fate === 'heading')
              expect([line, fate, told.has(line)]).toEqual([line, fate, true]);
          const faulty = new Set(read.faults.flatMap((one) => one.rows));
          for (const [line, fate] of fates)
            expect([line, fate, faulty.has(line)]).toEqual([line, fate, fate === 'fault']);
        }
      }),
      { numRuns: 400 },
    );
  });

  it('throws for no bytes and no text', () => {
    fc.assert(
      fc.property(fc.oneof(fc.uint8Array({ maxLength: 300 }), fc.string({ maxLength: 300 }), anyTable), (source) => {
        const { profile } = readRegisterMap(source);
        for (const { address } of profile.registers) expect(address >= 0 && address <= 0xffff).toBe(true);
      }),
      { numRuns: 400 },
    );
  });
});
