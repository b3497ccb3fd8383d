import { expect, it } from 'vitest';
import { defaultSettings, type ScanFinding, type ScanOrder } from '../../../../src/bus/index.ts';
import {
  type FindingWords,
  findingCells,
  findingColumns,
  findingsAsCsv,
  findingsAsMarkdown,
} from '../../../../src/workbench/bus/scan-table.ts';

const words: FindingWords = {
  columns: {
    unit: 'Unit',
    hex: 'Hex',
    line: 'Line',
    answer: 'Answer',
    time: 'Time',
    code: 'Code',
    name: 'Name',
    supported: 'Has it',
    addresses: 'Addresses',
    count: 'Count',
  },
  hexUnit: (unit) => `x${unit.toString(16)}`,
  line: ({ baud }) => `${baud} baud`,
  answer: ({ outcome }) => `a | ${outcome}, "so"`,
  unitAnswer: ({ outcome }) => `u | ${outcome}, "so"`,
  time: ({ duration }) => `${duration} ms`,
  notOpened: 'shut',
  functionCode: (code) => `f${code}`,
  functionName: (code) => `name ${code}`,
  supported: { yes: 'yes', no: 'no', unsure: 'unsure', silent: 'silent' },
  range: (first, last) => `${first} to ${last}`,
  hexRange: (first, last) => `x${first.toString(16)} to x${last.toString(16)}`,
};

const request = new Uint8Array(8);
const unit: ScanFinding = {
  what: 'unit',
  unit: 17,
  settings: defaultSettings,
  request,
  outcome: 'reply',
  duration: 20,
};
const shut: ScanFinding = { what: 'not-opened', settings: { ...defaultSettings, baud: 1200 } };
const units: ScanOrder = { kind: 'scan', what: 'units', transport: 'rtu', timeout: 1, first: 1, last: 2, lines: [] };
const functions: ScanOrder = { kind: 'scan', what: 'functions', transport: 'rtu', timeout: 1, unit: 1 };
const addresses: ScanOrder = {
  ...functions,
  what: 'addresses',
  table: 'coil',
  first: 0,
  last: 9,
  least: 1,
  most: 5,
};

it('has a cell for each column, of every kind of finding', () => {
  const refused: ScanFinding = {
    what: 'function',
    functionCode: 7,
    request,
    outcome: 'exception',
    exceptionCode: 1,
    duration: 3,
  };
  const found: ScanFinding = { what: 'addresses', first: 16, last: 31, request, outcome: 'reply', duration: 3 };
  expect(findingCells(unit, words)).toEqual(['17', 'x11', '19200 baud', 'u | reply, "so"', '20 ms']);
  expect(findingCells(shut, words)).toEqual(['', '', '1200 baud', 'shut', '']);
  expect(findingCells(refused, words)).toEqual(['f7', 'name 7', 'no', 'a | exception, "so"', '3 ms']);
  expect(findingCells(found, words)).toEqual(['16 to 31', 'x10 to x1f', '16', 'a | reply, "so"']);
  for (const [order, one] of [
    [units, unit],
    [units, shut],
    [functions, refused],
    [addresses, found],
  ] as const)
    expect(findingCells(one, words)).toHaveLength(findingColumns(order).length);
});

it('is written for a file and for a forum, each with its own marks', () => {
  expect(findingsAsCsv(units, [unit, shut], words)).toBe(
    'Unit,Hex,Line,Answer,Time\r\n17,x11,19200 baud,"u | reply, ""so""",20 ms\r\n,,1200 baud,shut,\r\n',
  );
  expect(findingsAsMarkdown(units, [unit], words)).toBe(
    '| Unit | Hex | Line | Answer | Time |\n| --- | --- | --- | --- | --- |\n| 17 | x11 | 19200 baud | u \\| reply, "so" | 20 ms |\n',
  );
});
