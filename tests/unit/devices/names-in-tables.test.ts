import { describe, expect, it } from 'vitest';
import { readTable, type TableRow, writeRequest } from '../../../src/devices/index.ts';

const rowsOf = (...rows: readonly (readonly string[])[]): TableRow[] =>
  rows.map((cells, index) => ({ line: index + 1, cells }));

/** Two rows of headers and cells: what makes a line whole, with `cells` instead. */
const lineOf = (cells: Readonly<Record<string, string>>) => {
  const { profile, faults } = readTable(rowsOf(Object.keys(cells), Object.values(cells)), 'file');
  expect(faults).toEqual([]);
  return profile.registers[0];
};
const whole = { name: 'Line', table: 'holding-register', address: '5' };

describe('the headers that name a column', () => {
  it.each(['name', 'parameter', 'tag', 'register', ' Name ', 'PARAMETER'])('of names: %s', (header) => {
    expect(lineOf({ table: 'coil', address: '5', [header]: 'x' })).toMatchObject({ name: 'x' });
  });

  it.each(['number', 'register number', 'modbus number', 'Register_Number', 'modbus   number'])(
    'of numbers: %s',
    (header) => {
      expect(lineOf({ name: 'x', [header]: '40006' })).toMatchObject({ table: 'holding-register', address: 5 });
    },
  );

  it.each([
    ['table', 'coil', { table: 'coil' }],
    ['area', 'coil', { table: 'coil' }],
    ['type', 'i16', { type: 'i16' }],
    ['data type', 'i16', { type: 'i16' }],
    ['datatype', 'i16', { type: 'i16' }],
    ['count', '3', { count: 3 }],
    ['quantity', '3', { count: 3 }],
    ['unit', 'Hz', { unit: 'Hz' }],
    ['units', 'Hz', { unit: 'Hz' }],
    ['access', 'r', { access: 'r' }],
    ['r/w', 'r', { access: 'r' }],
    ['names', '0=off', { names: [{ number: 0, name: 'off' }] }],
    ['values', '0=off', { names: [{ number: 0, name: 'off' }] }],
    ['description', 'd', { description: 'd' }],
    ['comment', 'd', { description: 'd' }],
  ])('%s', (header, cell, read) => {
    const { table, ...others } = whole;
    const own = 'table' in read ? others : { table, ...others };
    expect(lineOf({ ...own, [header]: cell })).toMatchObject(read);
  });
});

describe('the names of', () => {
  const names = {
    coil: ['coil', 'co', '0x', '0', ' CO '],
    'discrete-input': ['discrete-input', 'discrete', 'di', '1x', '1'],
    'input-register': ['input-register', 'input', 'ir', '3x', '3'],
    'holding-register': ['holding-register', 'holding', 'hr', '4x', '4'],
  };
  it.each(Object.entries(names).flatMap(([table, texts]) => texts.map((text) => [text, table] as const)))(
    'a table: %s',
    (text, table) => {
      expect(lineOf({ ...whole, table: text })).toMatchObject({ table });
    },
  );

  const access = { r: ['r', 'ro', 'read', 'R'], w: ['w', 'wo', 'write'], rw: ['rw', 'r/w', 'read/write'] };
  it.each(Object.entries(access).flatMap(([given, texts]) => texts.map((text) => [text, given] as const)))(
    'what may be done: %s',
    (text, given) => {
      expect(lineOf({ ...whole, access: text })).toMatchObject({ access: given });
    },
  );
});

describe('a row', () => {
  it('that ends early has nothing in the columns it does not come to', () => {
    const { profile, faults } = readTable(
      rowsOf(['name', 'table', 'address', 'unit', 'description'], ['x', 'coil', '5']),
      'file',
    );
    expect(faults).toEqual([]);
    expect(profile.registers).toMatchObject([{ name: 'x', table: 'coil', address: 5 }]);
    const { unit, description } = profile.registers[0]!;
    expect([unit, description]).toEqual(['', '']);
  });

  it('has a number with blanks around it', () => {
    expect(lineOf({ name: 'x', number: ' 40006 ' })).toMatchObject({ table: 'holding-register', address: 5 });
  });
});

describe('a request that writes a line', () => {
  const requestOf = (cells: Readonly<Record<string, string>>, index?: number) => {
    const { profile } = readTable(
      rowsOf(Object.keys({ ...whole, ...cells }), Object.values({ ...whole, ...cells })),
      'f',
    );
    return writeRequest(profile, profile.registers[0]!, index);
  };
  const zeros = (count: number) => new Array(count).fill(0);

  it('writes no more than a request holds: 123 registers, 1968 coils (AP 6.11, 6.12)', () => {
    expect(requestOf({ count: '200' })).toEqual({
      functionCode: 0x10,
      fields: { startAddress: 5, registers: zeros(123) },
      force: {},
    });
    expect(requestOf({ table: 'coil', count: '2000' }).fields).toEqual({ startAddress: 5, bits: zeros(1968) });
    expect(requestOf({}).fields).toEqual({ address: 5, value: 0 });
  });

  it.each([
    ['u32', 61, 122],
    ['f32', 61, 122],
    ['u64', 30, 120],
  ])('writes whole values of %s only: %i of 100 in %i registers', (type, _values, registers) => {
    expect(requestOf({ type, count: '100' })).toEqual({
      functionCode: 0x10,
      fields: { startAddress: 5, registers: zeros(registers) },
      force: {},
    });
  });

  it('writes one value of it, and a text whole', () => {
    expect(requestOf({ type: 'u32', count: '3' }, 2).fields).toEqual({ startAddress: 9, registers: zeros(2) });
    expect(requestOf({ count: '3' }, 2).fields).toEqual({ address: 7, value: 0 });
    expect(requestOf({ type: 'text', count: '3' }, 2).fields).toEqual({ startAddress: 5, registers: zeros(3) });
  });
});
