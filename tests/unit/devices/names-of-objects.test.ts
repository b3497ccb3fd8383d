import { expect, test } from 'vitest';
import { readProfiles, readTable, type TableRow } from '../../../src/devices/index.ts';

/** Names that every object has are names like others: a table of a device knows them no better than `abc`. */
const rowsOf = (...rows: readonly string[]): TableRow[] =>
  rows.map((row, index) => ({ line: index + 1, cells: row.split(',') }));

const oneRegister = (header: string, row: string) => readTable(rowsOf(header, row), 'file');

test('a setting', () => {
  expect(readTable(rowsOf('#__proto__,x', 'name,address'), 'file').faults).toEqual([
    { code: 'setting-unreadable', setting: '#__proto__', got: 'x', line: 1 },
  ]);
  const { profile, faults } = readTable(rowsOf('#constructor,abc', 'name,address'), 'file');
  expect(faults).toEqual([{ code: 'setting-unreadable', setting: '#constructor', got: 'abc', line: 1 }]);
  expect(Object.keys(profile).toSorted()).toEqual([
    'convention',
    'id',
    'name',
    'notes',
    'registers',
    'source',
    'traits',
  ]);
});

test('a header', () => {
  expect(readTable(rowsOf('name,address,constructor'), 'file').faults).toEqual([
    { code: 'column-unknown', got: 'constructor', line: 1 },
  ]);
  expect(readTable(rowsOf('toString,valueOf'), 'file').faults).toEqual([{ code: 'header-missing', line: 1 }]);
});

test('a type, a table, an access and an order', () => {
  expect(oneRegister('name,table,address,type', 'a,hr,1,constructor')).toMatchObject({
    profile: { registers: [] },
    faults: [{ code: 'cell-unknown', column: 'type', got: 'constructor' }],
  });
  expect(oneRegister('name,table,address', 'a,constructor,1')).toMatchObject({
    profile: { registers: [] },
    faults: [{ code: 'cell-unknown', column: 'table', got: 'constructor' }],
  });
  expect(oneRegister('name,table,address,access', 'a,hr,1,constructor')).toMatchObject({
    profile: { registers: [] },
    faults: [{ code: 'cell-unknown', column: 'access', got: 'constructor' }],
  });
  expect(oneRegister('name,table,address,order', 'a,hr,1,__proto__')).toMatchObject({
    profile: { registers: [] },
    faults: [{ code: 'cell-unknown', column: 'order', got: '__proto__' }],
  });
});

test('a name', () => {
  const { profile, faults } = oneRegister('name,table,address,names', 'constructor,hr,1,1=__proto__');
  expect(faults).toEqual([]);
  expect(profile.registers).toMatchObject([{ name: 'constructor', names: [{ number: 1, name: '__proto__' }] }]);
});

test('a type in a file of profiles', () => {
  const text =
    '{"format":"framewright-devices","version":1,"profiles":[{"name":"a","convention":"zero-based","registers":[{"name":"r","table":"hr","address":1,"type":"constructor"}]}]}';
  expect(readProfiles(text)).toMatchObject({
    kind: 'profiles',
    profiles: [
      { profile: { registers: [] }, faults: [{ code: 'cell-unknown', column: 'type', got: 'constructor', line: 1 }] },
    ],
  });
});
