import { expect, test } from 'vitest';
import {
  builtInProfiles,
  type Profile,
  plainRegister,
  readRegisterMap,
  writeMbmap,
} from '../../../../src/devices/index.ts';

const profile: Profile = {
  id: '',
  name: 'Pump station',
  source: 'Manual 3',
  convention: 'zero-based',
  traits: [],
  notes: [],
  registers: [
    {
      ...plainRegister,
      name: 'Flow',
      table: 'holding-register',
      address: 0,
      type: 'f32',
      order: 'CDAB',
      factor: 0.1,
      offset: -40,
      unit: '°C',
      decimals: 1,
    },
    {
      ...plainRegister,
      name: 'Mode',
      table: 'input-register',
      address: 2,
      type: 'i16',
      access: 'r',
      names: [
        { number: 0, name: 'Off' },
        { number: 1, name: 'On, hot; wet' },
      ],
      description: 'Text with = signs',
    },
    { ...plainRegister, name: 'Serial', table: 'holding-register', address: 10, type: 'text', count: 8, access: 'r' },
    {
      ...plainRegister,
      name: 'State',
      table: 'holding-register',
      address: 20,
      type: 'bits',
      names: [
        { number: 0, name: 'Run' },
        { number: 15, name: 'Fault' },
      ],
      group: 'Unit 1',
    },
    {
      ...plainRegister,
      name: 'State',
      table: 'holding-register',
      address: 21,
      type: 'bits',
      names: [{ number: 0, name: 'Run' }],
      group: 'Unit 2',
    },
    { ...plainRegister, name: 'Run', table: 'coil', address: 5, type: 'bits', access: 'w' },
    {
      ...plainRegister,
      name: 'Energy',
      table: 'holding-register',
      address: 30,
      type: 'u64',
      order: 'BADC',
      factor: 1000,
      models: ['X', 'Y'],
    },
    {
      ...plainRegister,
      name: 'Power',
      table: 'holding-register',
      address: 40,
      type: 'i16',
      count: 3,
      scaleRegister: { address: 43 },
    },
    { ...plainRegister, name: 'Exponent', table: 'holding-register', address: 43, type: 'i16' },
    { ...plainRegister, name: 'Valves', table: 'coil', address: 60, type: 'bits', count: 4 },
    { ...plainRegister, name: 'Low', table: 'holding-register', address: 50, mask: 0xff00, notImplemented: '0xFFFF' },
  ],
};

test('writes the base of addresses, the order of words, and the area and the scale of each register', () => {
  expect(JSON.parse(writeMbmap({ ...profile, registers: profile.registers.slice(0, 3) }))).toEqual({
    format: 'mbmap',
    version: 1,
    name: 'Pump station',
    source: 'Manual 3',
    addressBase: 0,
    wordOrder: 'big',
    registers: [
      {
        name: 'Flow',
        area: 'holding',
        address: 0,
        type: 'float32',
        wordOrder: 'CDAB',
        scale: 0.1,
        offset: -40,
        unit: '°C',
        decimals: 1,
        access: 'RW',
      },
      {
        name: 'Mode',
        area: 'input',
        address: 2,
        type: 'int16',
        access: 'RO',
        values: [
          { value: 0, name: 'Off' },
          { value: 1, name: 'On, hot; wet' },
        ],
        description: 'Text with = signs',
      },
      { name: 'Serial', area: 'holding', address: 10, type: 'string', length: 8, access: 'RO' },
    ],
  });
});

test('what is written is read back without a question', () => {
  expect(readRegisterMap(writeMbmap(profile), { name: 'pump.mbmap.json' })).toMatchObject({
    profile: { ...profile, name: 'Pump station' },
    questions: [],
    faults: [],
    notices: [],
  });
});

test('the order of words of most registers is that of the whole', () => {
  const swapped = profile.registers.map((register) => ({ ...register, order: 'CDAB' as const }));
  const text = writeMbmap({ ...profile, registers: swapped });
  expect(JSON.parse(text)).toMatchObject({ wordOrder: 'little' });
  expect(text.match(/wordOrder/g)).toHaveLength(1);
  expect(readRegisterMap(text).profile.registers[0]?.order).toBe('CDAB');
});

test.each(builtInProfiles.map((each) => [each.id, each] as const))('writes %s with all its registers', (_id, each) => {
  const read = readRegisterMap(writeMbmap(each));
  expect(read.faults).toEqual([]);
  expect(read.profile.registers.map(({ name, table, address, type }) => ({ name, table, address, type }))).toEqual(
    each.registers.map(({ name, table, address, type }) => ({ name, table, address, type })),
  );
});

test('reads files of the same kind that others wrote', () => {
  const entry = {
    area: 'holding',
    address: 1,
    name: 'Flow',
    dataType: 'float32',
    scale: 0.1,
    unit: 'm3/h',
    access: 'RW',
  };
  const map = {
    meta: { manufacturer: 'Maker', model: 'P3', addressBase: 1, wordOrder: 'little' },
    registers: [entry, { area: 'coil', address: 1, name: 'On' }],
  };
  expect(readRegisterMap(JSON.stringify(map), { name: 'pump.mbmap.json' })).toMatchObject({
    profile: {
      name: 'Maker P3',
      registers: [
        { name: 'Flow', table: 'holding-register', address: 0, type: 'f32', order: 'CDAB', factor: 0.1, unit: 'm3/h' },
        { name: 'On', table: 'coil', address: 0 },
      ],
    },
    questions: [],
    faults: [],
  });
});
