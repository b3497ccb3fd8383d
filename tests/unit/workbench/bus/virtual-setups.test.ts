import { describe, expect, it } from 'vitest';
import { type DeviceSetup, sourceSetups } from '../../../../src/bus/index.ts';
import { plainRegister } from '../../../../src/devices/index.ts';
import { readPace, readSetups, withKeptValues } from '../../../../src/workbench/bus/virtual-setups.ts';

const plain: DeviceSetup = {
  id: 7,
  version: 2,
  model: 'plain',
  profile: {
    id: 'pump',
    name: 'Pump',
    source: '',
    convention: 'zero-based',
    traits: [],
    registers: [{ ...plainRegister, name: 'Level', table: 'coil', type: 'bits', address: 3 }],
    notes: [],
  },
  unit: 247,
  on: false,
  values: [{ table: 'holding-register', from: 65_534, values: [0, 65_535] }],
};
const drive: DeviceSetup = { id: 1, model: 'weg-drive', unit: 6, on: true };

describe('virtual devices out of the storage', () => {
  it('are what was stored', () => {
    for (const devices of [[], [drive], [drive, plain], sourceSetups()])
      expect(readSetups(JSON.parse(JSON.stringify(devices)))).toEqual({ devices, bad: 0 });
  });

  it('have the old meaning of factors if they were kept without a version', () => {
    const register = {
      ...plainRegister,
      name: 'A',
      table: 'holding-register',
      address: 0,
      factor: 10,
      offset: 400,
    } as const;
    const { version: _, ...old } = { ...plain, profile: { ...plain.profile!, registers: [register] } };
    expect(readSetups([old])?.devices[0]?.profile?.registers).toMatchObject([{ factor: 0.1, offset: -40 }]);
    expect(readSetups([{ ...old, version: 2 }])?.devices[0]?.profile?.registers).toMatchObject([{ factor: 10 }]);
  });

  it('are those that can be used, and the others are counted', () => {
    const profile = plain.profile!;
    for (const change of [
      { id: 1.5 },
      { id: '7' },
      { model: 'constructor' },
      { unit: 0 },
      { unit: 248 },
      { on: 'yes' },
      { profile: null },
      { profile: { ...profile, registers: [{ ...plainRegister, name: 'A', table: 'constructor', address: 0 }] } },
      { profile: { ...profile, registers: 7 } },
      { values: {} },
      { values: [null] },
      { values: [{ table: 'file-record', from: 0, values: [] }] },
      { values: [{ table: 'coil', from: -1, values: [1] }] },
      { values: [{ table: 'coil', from: 65_535, values: [1, 1] }] },
      { values: [{ table: 'coil', from: 0, values: [65_536] }] },
      { values: [{ table: '__proto__', from: 0, values: [1] }] },
    ])
      expect([change, readSetups([drive, { ...plain, ...change }])]).toEqual([change, { devices: [drive], bad: 1 }]);
    for (const nonsense of [null, 7, 'x', [], {}])
      expect(readSetups([nonsense, drive])).toEqual({ devices: [drive], bad: 1 });
    expect(readSetups([drive, { ...plain, id: 1 }])).toEqual({ devices: [drive], bad: 1 });
  });

  it('are not there if no list is stored', () => {
    for (const nonsense of [null, undefined, 7, 'x', {}, { length: 3 }]) expect(readSetups(nonsense)).toBeUndefined();
  });

  it('go at one of two paces', () => {
    expect(['line', 'fast', 'slow', 1].map(readPace)).toEqual(['line', 'fast', undefined, undefined]);
  });
});

it('keeps the values that a session tells of its devices, and those of which it tells nothing', () => {
  const values = [{ table: 'coil', from: 1, values: [1] }] as const;
  expect(withKeptValues([drive, plain], [{ id: 1, values }])).toEqual([{ ...drive, values }, plain]);
});
