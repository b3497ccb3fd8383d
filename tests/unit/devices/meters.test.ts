import { describe, expect, test } from 'vitest';
import { builtInProfiles, namedValues, searchProfile } from '../../../src/devices/index.ts';

const of = (id: string) => {
  const found = builtInProfiles.find((profile) => profile.id === id);
  if (!found) throw new Error(`There is no ${id}.`);
  return found;
};

describe('meters and inverters that are here from the start', () => {
  test('SDM630: 4366 0000 is 230 V, 41F0 0000 after it is 30 V', () => {
    const values = namedValues(of('eastron-sdm630'), 'input-register', 0, [0x4366, 0x0000, 0x41f0, 0x0000]);
    expect(values).toMatchObject([
      { name: 'Phase 1 voltage', scaled: 230, register: { unit: 'V' } },
      { name: 'Phase 2 voltage', scaled: 30, register: { unit: 'V' } },
    ]);
  });

  test('SDM120: the energy is at 342', () => {
    expect(namedValues(of('eastron-sdm120'), 'input-register', 342, [0x42c8, 0])).toMatchObject([
      { name: 'Total active energy', scaled: 100 },
    ]);
  });

  test('SunSpec: W is 5003 × 10^-2, and the state has its name', () => {
    const profile = of('sunspec-inverter');
    expect(namedValues(profile, 'holding-register', 40084, [5003, 0xfffe])).toMatchObject([
      { name: 'W', scaled: 50.03 },
      { name: 'W_SF', scaled: -2 },
    ]);
    expect(namedValues(profile, 'holding-register', 40000, [0x5375, 0x6e53])).toMatchObject([{ raw: 'SunS' }]);
  });

  test('no register of a built-in device begins inside another, but where the source has it so', () => {
    for (const id of ['eastron-sdm630', 'eastron-sdm120', 'sunspec-inverter']) {
      const places = of(id).registers.map(({ table, address }) => `${table} ${address}`);
      expect(new Set(places).size).toBe(places.length);
    }
  });
});

test('the number of a register with its table’s digit finds it, also where the manual prints addresses', () => {
  // Eastron SDM630: 30003 is phase 2 line to neutral volts, 0x0002; SDM120: 30007 is current, 0x0006.
  for (const [id, text, name] of [
    ['eastron-sdm630', '30003', 'Phase 2 voltage'],
    ['eastron-sdm630', '300003', 'Phase 2 voltage'],
    ['eastron-sdm120', '30007', 'Current'],
  ] as const) {
    const profile = of(id);
    expect(
      searchProfile(profile, text).map(({ register }) => register.name),
      text,
    ).toEqual([name]);
    expect(searchProfile(profile, `1${text.slice(1)}`), text).toEqual([]);
  }
});
