import { describe, expect, it } from 'vitest';
import { type Profile, plainRegister, type Register, searchProfile } from '../../../../src/devices/index.ts';
import { filtersOf, foundName, isIn, type RegisterSort, sortedRegisters } from '../../../../src/workbench/index.ts';

const register = (name: string, address: number, more: Partial<Register> = {}): Register => ({
  ...plainRegister,
  name,
  table: 'holding-register',
  address,
  ...more,
});

const profile: Profile = {
  id: 'one',
  name: 'One',
  source: '',
  convention: 'five-digit',
  traits: [],
  notes: [],
  registers: [
    register('Zone 10', 9, { unit: 'V', access: 'r', models: ['X1'], group: 'Heating' }),
    register('Zone 9', 100, { type: 'f32', access: 'w', models: ['X1', 'X2'] }),
    register('Ready', 20, { table: 'coil', group: 'Status' }),
    register('Zone 1', 2, { unit: 'A', table: 'input-register', models: [] }),
  ],
};

const names = (sort: RegisterSort | undefined) =>
  sortedRegisters(profile, searchProfile(profile, ''), sort).map(foundName);

describe('registers in the order of a column', () => {
  it.each<[RegisterSort['by'], string]>([
    ['name', 'Ready, Zone 1, Zone 9, Zone 10'],
    // 00021, 30003, 40010, 40101.
    ['number', 'Ready, Zone 1, Zone 10, Zone 9'],
    ['type', 'Ready, Zone 9, Zone 10, Zone 1'],
    ['access', 'Zone 10, Ready, Zone 1, Zone 9'],
  ])('%s', (by, order) => {
    expect(names({ by, down: false }).join(', ')).toBe(order);
  });

  it('is the other way round, and the one of the map without a column', () => {
    expect(names({ by: 'name', down: true })).toEqual(['Zone 10', 'Zone 9', 'Zone 1', 'Ready']);
    expect(names(undefined)).toEqual(['Zone 10', 'Zone 9', 'Ready', 'Zone 1']);
  });

  it('has those without a unit last both ways', () => {
    expect(names({ by: 'unit', down: false })).toEqual(['Zone 1', 'Zone 10', 'Zone 9', 'Ready']);
    expect(names({ by: 'unit', down: true })).toEqual(['Zone 10', 'Zone 1', 'Zone 9', 'Ready']);
  });
});

describe('models and groups', () => {
  const left = (model: string, group: string) =>
    profile.registers.filter((each) => isIn(each, { model, group })).map(({ name }) => name);

  it('are those that the registers name', () => {
    expect(filtersOf(profile)).toEqual({ model: ['X1', 'X2'], group: ['Heating', 'Status'] });
    expect(filtersOf({ ...profile, registers: [register('A', 0)] })).toEqual({ model: [], group: [] });
  });

  it('narrow the map; a register without models belongs to every model', () => {
    expect(left('', '')).toEqual(['Zone 10', 'Zone 9', 'Ready', 'Zone 1']);
    expect(left('X2', '')).toEqual(['Zone 9', 'Ready', 'Zone 1']);
    expect(left('', 'Heating')).toEqual(['Zone 10']);
    expect(left('X2', 'Heating')).toEqual([]);
  });
});
