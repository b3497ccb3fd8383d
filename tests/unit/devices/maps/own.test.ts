import { expect, test } from 'vitest';
import { builtInProfiles, readRegisterMap, writeProfiles, writeTable } from '../../../../src/devices/index.ts';
import { writeCsvFile } from '../../../../src/notation/index.ts';

const nothingAsked = { questions: [], faults: [], notices: [] };

test.each(builtInProfiles.map((profile) => [profile.id, profile] as const))(
  'the profile %s comes back from our JSON and our CSV, without a question',
  (_id, profile) => {
    expect(readRegisterMap(writeProfiles([profile]))).toMatchObject({ profile, ...nothingAsked });
    expect(readRegisterMap(writeCsvFile(writeTable(profile)))).toMatchObject({ profile, ...nothingAsked });
    expect(
      readRegisterMap(
        writeTable(profile)
          .map((cells) => cells.join('\t'))
          .join('\r\n'),
      ),
    ).toMatchObject({ profile });
  },
);

test('a file of ours without a version has the old meaning of a scale', () => {
  const text = '#id,pump\n#name,Pump\n#convention,zero-based\nname,table,address,factor\nFlow,holding-register,3,10\n';
  expect(readRegisterMap(text).profile.registers[0]?.factor).toBe(0.1);
  expect(readRegisterMap(text.replace('#name', '#version,2\n#name')).profile.registers[0]?.factor).toBe(10);
  const register = { name: 'Flow', table: 'holding-register', address: 3, factor: 10 };
  const profile = {
    id: 'pump',
    name: 'Pump',
    source: '',
    convention: 'zero-based',
    traits: [],
    notes: [],
    registers: [register],
  };
  const json = (version: number) => JSON.stringify({ format: 'framewright-devices', version, profiles: [profile] });
  expect(readRegisterMap(json(1)).profile.registers[0]?.factor).toBe(0.1);
  expect(readRegisterMap(json(2)).profile.registers[0]?.factor).toBe(10);
  expect(readRegisterMap(json(9)).faults).toEqual([
    { code: 'own-file', fault: { code: 'newer-version', version: 9 }, rows: [] },
  ]);
  // The name of a member that every object has is no type.
  expect(readRegisterMap(json(2).replace('"factor":10', '"type":"constructor"')).faults).toMatchObject([
    { code: 'own-table', rows: [1], fault: { code: 'cell-unknown', column: 'type', got: 'constructor' } },
  ]);
});

test('a line of ours that cannot be read is told with its row, and a setting that is unknown too', () => {
  const text =
    '#id,pump\n#convention,zero-based\n#colour,red\nname,table,address\nFlow,holding-register,70000\nLevel,coil,1\n';
  const read = readRegisterMap(text);
  expect(read.profile.registers.map(({ name }) => name)).toEqual(['Level']);
  expect(read.faults).toMatchObject([
    { code: 'own-table', rows: [5], fault: { code: 'cell-out-of-range', column: 'address' } },
  ]);
  expect(read.notices).toMatchObject([{ code: 'own-table', rows: [3], fault: { code: 'setting-unreadable' } }]);
});

test('a table of ours that lost its header is read as any other', () => {
  expect(
    readRegisterMap('#id,pump\n#convention,zero-based\nParameter,Modbus address\nFlow,12\n').profile.registers,
  ).toMatchObject([{ name: 'Flow', address: 12 }]);
});
