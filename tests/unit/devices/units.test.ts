import { expect, test } from 'vitest';
import {
  builtInProfiles,
  linesBehind,
  type Profile,
  plainRegister,
  type Register,
  unitScale,
} from '../../../src/devices/index.ts';
import { fraction } from '../../../src/modbus/index.ts';
import { readValues, writeInUnits } from '../../../src/notation/index.ts';

const weg = builtInProfiles.find(({ id }) => id === 'weg-drive')!;
const namesBehind = (profile: Profile, first: number, place: number) =>
  linesBehind(profile, 'holding-register', first, place).map(({ name }) => name);

const line = (name: string, address: number, more: Partial<Register> = {}): Register => ({
  ...plainRegister,
  table: 'holding-register',
  name,
  address,
  ...more,
});

test('the drive’s table of five rows', () => {
  const [reference] = linesBehind(weg, 'holding-register', 683, 0);
  const hertz = unitScale(reference!)!;
  // 60 / 8192 as a double is taken for the quotient that was meant.
  expect(hertz).toMatchObject({ unit: 'Hz', type: 'i16', scale: { factor: fraction(60, 8192), decimals: 1 } });
  for (const [value, raw] of [
    [0, 0],
    [15, 2048],
    [30, 4096],
    [45, 6144],
    [60, 8192],
  ] as const) {
    expect(writeInUnits(fraction(value), hertz)).toMatchObject({ registers: [raw], inUnits: { exact: true } });
  }
});

test('no line is behind the end of a table, whether values or registers are counted', () => {
  for (const profile of builtInProfiles) {
    expect(namesBehind(profile, 0, 1e300)).toEqual([]);
    expect(namesBehind(profile, 0xffff, 0x10000)).toEqual([]);
  }
});

test('the lines behind a first register', () => {
  expect(namesBehind(weg, 681, 0)).toEqual(['P0681 actual speed']);
  expect(namesBehind(weg, 681, 2)).toEqual(['P0683 speed reference']);
  expect(namesBehind(weg, 681, 3)).toEqual([]);
  const { values, faults } = readValues('30 Hz, 1, 60 Hz', (place) =>
    linesBehind(weg, 'holding-register', 681, place)
      .map(unitScale)
      .filter((known) => known !== undefined),
  );
  expect(faults).toEqual([]);
  expect(values.flatMap(({ registers }) => registers)).toEqual([4096, 1, 8192]);
});

test('a value of several registers begins at its first alone', () => {
  const profile: Profile = { ...weg, registers: [line('flow', 10, { type: 'f32', unit: 'm³/h' }), line('state', 12)] };
  expect(namesBehind(profile, 10, 0)).toEqual(['flow']);
  expect(namesBehind(profile, 10, 1)).toEqual([]);
  expect(namesBehind(profile, 10, 2)).toEqual(['state']);
  // Each value counted as one address, and sent whole.
  const enron: Profile = {
    ...profile,
    traits: ['one-address-each-value'],
    registers: [line('a', 7001, { type: 'f32' }), line('b', 7002, { type: 'f32' })],
  };
  expect(namesBehind(enron, 7001, 2)).toEqual(['b']);
  expect(namesBehind(enron, 7001, 1)).toEqual([]);
});

test('lines without a unit have no scale, and decimals follow the factor where none are named', () => {
  expect(unitScale(line('plain', 0))).toBeUndefined();
  expect(unitScale(line('name', 0, { type: 'text', unit: 'x' }))).toBeUndefined();
  expect(unitScale(line('tenths', 0, { factor: 0.1, unit: '°C' }))?.scale.decimals).toBe(1);
  expect(unitScale(line('tens', 0, { factor: 10, unit: 'kW' }))?.scale).toMatchObject({
    factor: fraction(10),
    decimals: 0,
  });
});
