import { expect, it } from 'vitest';
import { readCells, readProfiles } from '../../../src/devices/index.ts';

const context = { convention: 'zero-based', traits: [] } as const;
const read = (type: string, order = '', table = 'holding') => {
  const reading = readCells({ name: 'A', table, address: '0', type, order }, context);
  return reading.kind === 'register' ? reading.register : reading.faults;
};

it.each([
  ['uint16', '', { type: 'u16' }],
  ['INT32', '', { type: 'i32' }],
  ['Float', '', { type: 'f32' }],
  ['REAL', 'word swap', { type: 'f32', order: 'CDAB' }],
  ['u64', 'GHEFCDAB', { type: 'u64', order: 'CDAB' }],
  ['u16', 'BA', { type: 'u16', order: 'BADC' }],
  ['U_DWORD_R', '', { type: 'u32', order: 'CDAB' }],
  ['U_DWORD_R', 'ABCD', { type: 'u32', order: 'ABCD' }],
  ['STRING[8]', '', { type: 'text', count: 4 }],
])('takes the type %s and the order %j in a table', (type, order, expected) => {
  expect(read(type, order)).toMatchObject(expected);
});

it('takes BOOL for a coil, and for the bits of a register', () => {
  expect(read('BOOL', '', 'coil')).toMatchObject({ table: 'coil', type: 'bits' });
  expect(read('BOOL')).toMatchObject({ table: 'holding-register', type: 'bits' });
});

it('still refuses what is not a type or an order', () => {
  expect(read('Voltage')).toMatchObject([{ code: 'cell-unknown', column: 'type', got: 'Voltage' }]);
  expect(read('u16', 'sideways')).toMatchObject([{ code: 'cell-unknown', column: 'order', got: 'sideways' }]);
});

it('takes the same names in JSON', () => {
  const registers = [{ name: 'A', table: 'holding', address: 0, type: 'UDINT', order: 'word swap' }];
  const profiles = [{ id: 'a', name: 'A', source: '', convention: 'zero-based', registers }];
  const reading = readProfiles(JSON.stringify({ format: 'framewright-devices', version: 1, profiles }));
  expect(reading).toMatchObject({ profiles: [{ profile: { registers: [{ type: 'u32', order: 'CDAB' }] } }] });
});
