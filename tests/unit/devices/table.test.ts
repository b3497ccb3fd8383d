import fc from 'fast-check';
import { expect, test } from 'vitest';
import {
  accesses,
  builtInProfiles,
  byteOrders,
  conventions,
  deviceTraits,
  isBitTable,
  isReadOnly,
  type Profile,
  readProfiles,
  readTable,
  type TableRow,
  valueTypes,
  writeProfiles,
  writeTable,
} from '../../../src/devices/index.ts';

const rowsOf = (...rows: readonly (readonly string[])[]): TableRow[] =>
  rows.map((cells, index) => ({ line: index + 1, cells }));

const HEADER = ['name', 'table', 'address', 'type', 'factor', 'names'];

test('a table with settings, headers by other names and decimal commas', () => {
  const { profile, faults } = readTable(
    rowsOf(
      ['#name', 'Pump'],
      ['#convention', 'five-digit'],
      ['#serial', '9600', '8', 'none', '1', '6'],
      ['#note', 'Page 12 has it wrong.'],
      ['Parameter', 'Area', 'Register Number', 'Data Type', 'Units', 'factor', 'R/W', 'Bits'],
      ['Pressure', '', '40108', 'f32', 'bar', '0,5', 'ro', ''],
      [' Mode ', 'Holding Registers', '3', '', '', '8192/60', '', '0=off; 1: on\\; warm'],
    ),
    'file',
  );
  expect(faults).toEqual([]);
  expect(profile).toMatchObject({
    name: 'Pump',
    convention: 'five-digit',
    serial: { baud: 9600, dataBits: 8, parity: 'none', stopBits: 1, unit: 6 },
    notes: ['Page 12 has it wrong.'],
    registers: [
      { name: 'Pressure', table: 'holding-register', address: 107, type: 'f32', unit: 'bar', factor: 0.5, access: 'r' },
      {
        name: 'Mode',
        address: 2,
        factor: 8192 / 60,
        names: [
          { number: 0, name: 'off' },
          { number: 1, name: 'on; warm' },
        ],
      },
    ],
  });
});

test.each([
  [['40108', '30001'], 'five-digit', [107, 0]],
  [['400108', '300001'], 'six-digit', [107, 0]],
  [['108', '1'], 'one-based', [107, 0]],
])('a column of numbers says its convention: %j', (numbers, convention, addresses) => {
  const table = convention === 'one-based' ? 'holding' : '';
  const rows = rowsOf(['name', 'number', 'table'], ...numbers.map((number, index) => [`R${index}`, number, table]));
  const { profile, faults } = readTable(rows, 'file');
  expect(faults).toEqual([]);
  expect(profile.convention).toBe(convention);
  expect(profile.registers.map(({ address }) => address)).toEqual(addresses);
});

test('an address beside a number of another is refused, and one that agrees is not', () => {
  const rows = rowsOf(['name', 'address', 'number'], ['A', '107', '40108'], ['B', '108', '40108'], ['C', '', '']);
  const { profile, faults } = readTable(rows, 'file');
  expect(profile.registers).toMatchObject([{ name: 'A', address: 107 }]);
  expect(faults).toEqual([
    { code: 'address-contradicts-number', number: '40108', expected: 107, got: 108, line: 3 },
    { code: 'cell-missing', column: 'table', line: 4 },
    { code: 'cell-missing', column: 'number', line: 4 },
  ]);
});

/** Ten tables that are wrong: what is left of each, and what is said of the rest. */
const malformed: readonly {
  readonly what: string;
  readonly rows: readonly TableRow[];
  readonly names: readonly string[];
  readonly faults: readonly unknown[];
}[] = [
  { what: 'nothing at all', rows: [], names: [], faults: [{ code: 'header-missing', line: 1 }] },
  {
    what: 'no row of headers',
    rows: rowsOf(['Speed', 'holding', '681']),
    names: [],
    faults: [{ code: 'header-missing', line: 1 }],
  },
  {
    what: 'an address that is a word, one that is negative, one past the end',
    rows: rowsOf(
      HEADER,
      ['A', 'holding', 'first'],
      ['B', 'holding', '-1'],
      ['C', 'holding', '65536'],
      ['D', 'holding', '0xFFFF'],
    ),
    names: ['D'],
    faults: [
      { code: 'cell-not-a-number', column: 'address', got: 'first', line: 2 },
      { code: 'cell-out-of-range', column: 'address', got: -1, least: 0, most: 65535, line: 3 },
      { code: 'cell-out-of-range', column: 'address', got: 65536, least: 0, most: 65535, line: 4 },
    ],
  },
  {
    what: 'a type nobody knows, beside a good row',
    rows: rowsOf(HEADER, ['A', 'holding', '1', 'triple'], ['B', 'holding', '2', 'U16']),
    names: ['B'],
    faults: [{ code: 'cell-unknown', column: 'type', got: 'triple', known: valueTypes, line: 2 }],
  },
  {
    what: 'a register twice; a name alone may repeat',
    rows: rowsOf(HEADER, ['A', 'holding', '1'], ['A', 'holding', '2'], ['A', 'holding', '1']),
    names: ['A', 'A'],
    faults: [{ code: 'name-twice', name: 'A', first: 2, line: 4 }],
  },
  {
    what: 'cells beyond the headers, as an unquoted comma makes them',
    rows: rowsOf(['name', 'table', 'address'], ['A', 'holding', '1', 'so, what']),
    names: [],
    faults: [{ code: 'too-many-cells', got: 4, most: 3, line: 2 }],
  },
  {
    what: 'no name, no table, no address',
    rows: rowsOf(HEADER, ['', 'holding', '1'], ['B', '', '1'], ['C', 'holding', '']),
    names: [],
    faults: [
      { code: 'cell-missing', column: 'name', line: 2 },
      { code: 'cell-missing', column: 'table', line: 3 },
      { code: 'cell-missing', column: 'address', line: 4 },
    ],
  },
  {
    what: 'a float that ends past the last address, and a factor of 0',
    rows: rowsOf(
      HEADER,
      ['A', 'holding', '65535', 'f32'],
      ['B', 'holding', '1', '', '0'],
      ['C', 'holding', '1', '', 'x'],
    ),
    names: [],
    faults: [
      { code: 'over-the-end', address: 65535, last: 65536, line: 2 },
      { code: 'factor-zero', line: 3 },
      { code: 'cell-not-a-number', column: 'factor', got: 'x', line: 4 },
    ],
  },
  {
    what: 'a coil of 32 bits, writable inputs, names without numbers',
    rows: rowsOf(
      ['name', 'table', 'address', 'type', 'access', 'names'],
      ['A', 'coil', '1', 'u32'],
      ['B', 'input', '1', '', 'rw'],
      ['C', 'hr', '1', '', '', 'run; stop'],
    ),
    names: [],
    faults: [
      { code: 'type-not-for-table', got: 'u32', table: 'coil', line: 2 },
      { code: 'table-read-only', table: 'input-register', line: 3 },
      { code: 'names-unreadable', got: 'run; stop', line: 4 },
    ],
  },
  {
    what: 'a quote that is never closed, settings that say nothing, columns unknown and twice',
    rows: [
      ...rowsOf(
        ['#serial', 'fast'],
        ['#colour', 'red'],
        ['name', 'table', 'address', 'Colour', 'Name'],
        ['A', 'holding', '1', 'red', 'B'],
      ),
      { line: 5, cells: ['"B', 'holding', '2'], open: true },
    ],
    names: ['A'],
    faults: [
      { code: 'setting-unreadable', setting: '#serial', got: 'fast', line: 1 },
      { code: 'setting-unreadable', setting: '#colour', got: 'red', line: 2 },
      { code: 'column-unknown', got: 'Colour', line: 3 },
      { code: 'column-twice', column: 'name', line: 3 },
      { code: 'quote-open', line: 5 },
    ],
  },
  {
    what: 'five-digit numbers in the column of addresses',
    rows: rowsOf(HEADER, ['A', 'holding', '40001'], ['B', 'holding', '40002'], ['C', 'coil', '3']),
    names: ['A', 'B', 'C'],
    faults: [{ code: 'addresses-like-numbers', line: 1 }],
  },
  {
    what: 'a number of another table than the row says',
    rows: rowsOf(['#convention', 'five-digit'], ['name', 'number', 'table'], ['A', '30001', 'holding'], ['B', '0', '']),
    names: [],
    faults: [
      { code: 'number-of-other-table', got: '30001', table: 'input-register', line: 3 },
      { code: 'cell-out-of-range', column: 'number', got: 0, least: 1, most: 65536, line: 4 },
      { code: 'cell-missing', column: 'table', line: 4 },
    ],
  },
];

test.each(malformed)('malformed: $what', ({ rows, names, faults: expected }) => {
  const { profile, faults } = readTable(rows, 'file');
  expect(profile.registers.map(({ name }) => name)).toEqual(names);
  expect(faults).toEqual(expected);
});

const trimmed = fc.string({ maxLength: 12 }).map((text) => text.trim());
const named = trimmed.filter((text) => text !== '');
const number = fc.double({ noNaN: true, noDefaultInfinity: true }).map((value) => (value === 0 ? 0 : value));

const register = fc
  .record({
    name: named,
    table: fc.constantFrom('coil', 'discrete-input', 'input-register', 'holding-register'),
    address: fc.nat(60000),
    type: fc.constantFrom(...valueTypes),
    order: fc.constantFrom(...byteOrders),
    count: fc.integer({ min: 1, max: 100 }),
    factor: number.map((value) => value || 1),
    offset: number,
    unit: trimmed,
    decimals: fc.option(fc.nat(10), { nil: undefined }),
    access: fc.constantFrom(...accesses),
    names: fc.array(fc.record({ number: fc.integer({ min: -9, max: 99 }), name: named }), { maxLength: 3 }),
    description: trimmed,
  })
  .map((any) => ({
    ...any,
    type: isBitTable(any.table) ? ('bits' as const) : any.type,
    access: isReadOnly(any.table) ? ('r' as const) : any.access,
  }));

const profiles: fc.Arbitrary<Profile> = fc.record({
  id: trimmed,
  name: named,
  source: trimmed,
  convention: fc.constantFrom(...conventions),
  serial: fc.option(
    fc.record({
      baud: fc.integer({ min: 1, max: 1_000_000 }),
      dataBits: fc.constantFrom(7, 8),
      parity: fc.constantFrom('none', 'even', 'odd'),
      stopBits: fc.constantFrom(1, 2),
      unit: fc.option(fc.nat(255), { nil: undefined }),
    }),
    { nil: undefined },
  ),
  traits: fc.uniqueArray(fc.constantFrom(...deviceTraits)),
  registers: fc.uniqueArray(register, { maxLength: 5, selector: ({ name }) => name }),
  notes: fc.array(named, { maxLength: 3 }),
});

/** Tables print numbers of holding registers and addresses alike; the notice about them is no loss. */
const losses = (faults: readonly { readonly code: string }[]) =>
  faults.filter(({ code }) => code !== 'addresses-like-numbers');

test('what is written as a table or as JSON is read back as it was', () => {
  fc.assert(
    fc.property(profiles, (profile) => {
      const table = readTable(rowsOf(...writeTable(profile)), 'file');
      expect(losses(table.faults)).toEqual([]);
      expect(table.profile).toEqual(profile);
      const json = readProfiles(writeProfiles([profile]));
      expect(json).toEqual({ kind: 'profiles', profiles: [{ profile, faults: [] }] });
    }),
  );
});

test('the built-in profiles survive both', () => {
  for (const profile of builtInProfiles) {
    expect(readTable(rowsOf(...writeTable(profile)), 'file')).toEqual({ profile, faults: [] });
  }
  expect(readProfiles(writeProfiles(builtInProfiles))).toEqual({
    kind: 'profiles',
    profiles: builtInProfiles.map((profile) => ({ profile, faults: [] })),
  });
});

test('any text and any table is answered, not thrown at', () => {
  fc.assert(
    fc.property(fc.string(), fc.array(fc.array(fc.string())), fc.json(), (text, cells, json) => {
      readProfiles(text);
      readProfiles(`{"format":"framewright-devices","version":1,"profiles":[{"registers":[${json}],"names":${json}}]}`);
      readTable(rowsOf(...cells), 'file');
      readTable(rowsOf(['name', 'address', 'table'], ...cells), 'file');
    }),
  );
});

test.each([
  ['{', { code: 'not-json' }],
  ['[]', { code: 'not-profiles' }],
  ['{"format":"framewright-frames","version":1,"frames":[]}', { code: 'not-profiles' }],
  ['{"format":"framewright-devices","version":3,"profiles":[]}', { code: 'newer-version', version: 3 }],
])('no file of profiles: %s', (text, fault) => {
  expect(readProfiles(text)).toMatchObject({ kind: 'unreadable', fault });
});
