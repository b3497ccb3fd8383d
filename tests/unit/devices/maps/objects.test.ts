import fc from 'fast-check';
import { expect, test } from 'vitest';
import { readSheets } from '../../../../src/devices/maps/read-sheets.ts';
import { usualLimits } from '../../../../src/devices/maps/sheet.ts';

const sheetsOf = (value: unknown) => readSheets(JSON.stringify(value)).sheets;
const cellsOf = (source: string, name?: string) =>
  readSheets(source, name).sheets.map(({ rows }) => rows.map(({ cells }) => cells));

test('reads a list of objects under any key, and numbers its items', () => {
  const value = {
    info: { version: 3 },
    points: [
      { id: 'power', address: 52, scale: 1e-7 },
      { id: 'on', address: 53, writable: true },
    ],
  };
  expect(sheetsOf(value)).toEqual([
    {
      name: 'points',
      kind: 'objects',
      headed: true,
      rows: [
        { line: 0, cells: ['id', 'address', 'scale', 'writable'] },
        { line: 1, cells: ['power', '52', '0.0000001', ''] },
        { line: 2, cells: ['on', '53', '', 'true'] },
      ],
    },
  ]);
});

test('a list in a list stands for its items, which keep what the outer one says', () => {
  const value = {
    endianness: 'BigEndian',
    blocks: [
      { id: 'a', registers: [{ address: 0 }, { address: 2 }] },
      { id: 'b', registers: [{ address: 4 }] },
    ],
  };
  expect(sheetsOf(value)).toEqual([
    {
      name: 'registers',
      kind: 'objects',
      headed: true,
      facts: { order: 'BigEndian' },
      rows: [
        { line: 0, cells: ['blocks.id', 'address'] },
        { line: 1, cells: ['a', '0'] },
        { line: 2, cells: ['a', '2'] },
      ],
    },
    {
      name: 'registers',
      kind: 'objects',
      headed: true,
      facts: { order: 'BigEndian' },
      rows: [
        { line: 0, cells: ['blocks.id', 'address'] },
        { line: 3, cells: ['b', '4'] },
      ],
    },
  ]);
});

test.each([
  ['holding_registers', 'holding-register'],
  ['holdingRegs', 'holding-register'],
  ['hold', 'holding-register'],
  ['inputRegisters', 'input-register'],
  ['input', 'input-register'],
  ['coils', 'coil'],
  ['discrete_inputs', 'discrete-input'],
  ['disInputs', 'discrete-input'],
  ['read_only_word', 'input-register'],
])('takes the table from the key %s', (key, table) => {
  expect(sheetsOf({ [key]: [{ address: 1 }] })[0]?.facts).toEqual({ table });
});

test('takes the device, the unit and the counting from what stands beside the list', () => {
  expect(
    sheetsOf({ device: 'Pump 3', slave_id: 7, base_address: 1000, registers: [{ address: 1 }] })[0]?.facts,
  ).toEqual({
    device: 'Pump 3',
    unit: '7',
    addressBase: '1000',
  });
  expect(sheetsOf({ addressBase: 1, registers: [{ address: 1 }] })[0]?.facts).toEqual({ counting: 'one' });
  expect(sheetsOf({ zero_based: false, registers: [{ address: 1 }] })[0]?.facts).toEqual({ counting: 'one' });
});

test('maps of objects are lists, by address or by name', () => {
  expect(cellsOf('{"40001":{"name":"A"},"40002":{"name":"B"}}')).toEqual([
    [
      ['address', 'name'],
      ['40001', 'A'],
      ['40002', 'B'],
    ],
  ]);
  expect(cellsOf('{"version":1,"voltage":{"addr":0},"current":{"addr":2}}')).toEqual([
    [
      ['name', 'addr'],
      ['voltage', '0'],
      ['current', '2'],
    ],
  ]);
});

test('flattens keys inside keys, joins lists, and writes names of values in one cell', () => {
  const item = {
    address: 1,
    scale: { factor: 0.1, offset: -5 },
    models: ['A', 'B'],
    values: [
      { value: 0, name: 'Off' },
      { value: 1, name: 'On; hot' },
    ],
    map: { 0: 'No', 1: 'Yes' },
    states: { Idle: 3, Run: 4 },
  };
  expect(cellsOf(JSON.stringify([item]))).toEqual([
    [
      ['address', 'scale.factor', 'scale.offset', 'models', 'values', 'map', 'states'],
      ['1', '0.1', '-5', 'A, B', '0=Off; 1=On\\; hot', '0=No; 1=Yes', '3=Idle; 4=Run'],
    ],
  ]);
});

test('registers that follow each other are a range, and the order of words is not that of bytes', () => {
  const items = [
    { name: 'A', registers: [9, 10] },
    { name: 'B', registers: [7] },
    { name: 'C', registers: [4, 3] },
  ];
  expect(sheetsOf({ word_order: 'little', parameters: [{ group: 'x', items }] })).toMatchObject([
    {
      facts: { order: 'CDAB' },
      rows: [{}, { cells: ['x', 'A', '9-10'] }, { cells: ['x', 'B', '7'] }, { cells: ['x', 'C', '4, 3'] }],
    },
  ]);
});

test('reads maps of addresses and names', () => {
  expect(
    sheetsOf({
      holding: { 40001: 'Voltage', 40002: 'Current' },
      input_registers: { flow: 3, level: '0x10' },
      port: { a: 1, b: 2 },
    }),
  ).toMatchObject([
    {
      name: 'holding',
      headed: true,
      facts: { table: 'holding-register' },
      rows: [{ cells: ['address', 'name'] }, { line: 1, cells: ['40001', 'Voltage'] }, { cells: ['40002', 'Current'] }],
    },
    {
      name: 'input_registers',
      facts: { table: 'input-register' },
      rows: [{ cells: ['name', 'address'] }, { cells: ['flow', '3'] }, { line: 4, cells: ['level', '0x10'] }],
    },
  ]);
});

test('reads JSON with comments and commas too many, and one object a line', () => {
  const rows = [
    ['address', 'name'],
    ['1', 'http://x, /* y */ ,]'],
  ];
  expect(
    cellsOf('// map\n{ "registers": [ /* one */ { "address": 1, "name": "http://x, /* y */ ,]", }, // last\n ], }'),
  ).toEqual([rows]);
  expect(cellsOf('{"address":1,"name":"A"}\n{"address":2,"name":"B"}\n')).toEqual([
    [
      ['address', 'name'],
      ['1', 'A'],
      ['2', 'B'],
    ],
  ]);
});

test('says that a text which begins like JSON is not', () => {
  expect(readSheets('{ "registers": [ { "address": 1 } ')).toMatchObject({
    sheets: [],
    problems: [{ code: 'unreadable', format: 'json' }],
    format: '',
  });
  expect(readSheets('[{"address": 1}, {"address": }]').problems).toMatchObject([{ code: 'unreadable' }]);
});

test('reads rows of cells', () => {
  expect(
    sheetsOf([
      ['name', 'address'],
      ['A', 0],
    ]),
  ).toEqual([
    {
      kind: 'objects',
      rows: [
        { line: 1, cells: ['name', 'address'] },
        { line: 2, cells: ['A', '0'] },
      ],
    },
  ]);
});

test('reads YAML with its digits as they are, keys that repeat, anchors, and tags', () => {
  const text = `
defaults: &defaults
  unit: V
registers:
  - <<: *defaults
    address: 0x0010 # the first
    name: "Voltage: L1"
  - address: 0064
    unit: !custom A
    unit: mA
`;
  expect(cellsOf(text)).toEqual([
    [
      ['unit', 'address', 'name', 'unit 2'],
      ['V', '0x0010', 'Voltage: L1', ''],
      ['A', '0064', '', 'mA'],
    ],
  ]);
});

test('reads several documents, and what stands before an error', () => {
  expect(cellsOf('registers:\n- address: 1\n---\nregisters:\n- address: 2\n')).toHaveLength(2);
  const broken = readSheets('registers:\n- address: 1\n- address: [2\n- address: 3\n', 'map.yaml');
  expect(broken.problems[0]).toMatchObject({ code: 'unreadable', format: 'yaml' });
  expect(broken.sheets).toHaveLength(1);
});

test('aliases that stand for more than a file may hold are a problem, not a hang', () => {
  const levels = Array.from({ length: 30 }, (_, index) =>
    `a${index}: &a${index} [${`*a${index - 1},`.repeat(9)}]`.replaceAll('*a-1', '{address: 1}'),
  );
  const read = readSheets(levels.join('\n'), '', { ...usualLimits, nodes: 20_000 });
  expect(read.problems.map(({ code }) => code)).toContain('too-many-cells');
});

test.each([
  ['brackets', `- ${'['.repeat(100_000)}`],
  ['closed brackets', `${'['.repeat(5000)}${']'.repeat(5000)}`],
  ['maps in brackets', `a: ${'{b: '.repeat(3000)}`],
  ['items in items', `${'- '.repeat(50_000)}a: 1`],
  ['keys in keys', Array.from({ length: 2000 }, (_, index) => `${' '.repeat(index)}a:`).join('\n')],
  ['complex keys', `${'? '.repeat(3000)}a`],
  ['tags', `a: ${'!x '.repeat(50_000)}`],
  ['brackets between closed ones in texts', `a: ${'["]",'.repeat(3000)}`],
])('%s without end are refused, not read until the stack ends', (_what, text) => {
  expect(readSheets(text, 'map.yaml')).toMatchObject({
    sheets: [],
    problems:
      text.startsWith('[[[[') && text.endsWith(']') ? [] : [{ code: 'unreadable', format: 'yaml', detail: 'too deep' }],
  });
});

test('many brackets beside each other are not deep', () => {
  const text = `registers:\n${Array.from({ length: 300 }, (_, index) => `- {address: ${index}, range: "[0, 5)", models: [A, B]}`).join('\n')}`;
  expect(readSheets(text).sheets[0]?.rows).toHaveLength(301);
});

const scalar = fc.oneof(fc.integer(), fc.boolean(), fc.string({ maxLength: 6 }));
const registers = fc.array(fc.record({ address: fc.nat(65_535), name: fc.string({ maxLength: 6 }), more: scalar }), {
  minLength: 1,
  maxLength: 6,
});

test('every cell of a list comes out again, however deep it lies', () => {
  fc.assert(
    fc.property(registers, fc.array(fc.constantFrom('a', 'b', 'map', 'device'), { maxLength: 5 }), (list, path) => {
      const value = path.reduce<unknown>((inner, key) => ({ [key]: inner, version: 1 }), { registers: list });
      const [sheet] = sheetsOf(value);
      const cells = list.map(({ address, name, more }) => [String(address), name, String(more)]);
      expect(sheet?.rows.slice(1).map((row) => row.cells)).toEqual(cells);
    }),
  );
});

test('any value of JSON is read', () => {
  fc.assert(
    fc.property(fc.json({ maxDepth: 6 }), (text) => {
      expect(Array.isArray(readSheets(text).sheets)).toBe(true);
    }),
  );
});
