import fc from 'fast-check';
import { expect, test } from 'vitest';
import {
  builtInProfiles,
  nameAt,
  type Profile,
  placesNamed,
  plainRegister,
  readRequest,
  readRequests,
} from '../../../src/devices/index.ts';
import { isTextType } from '../../../src/modbus/index.ts';

const profileOf = (id: string): Profile => builtInProfiles.find((profile) => profile.id === id)!;
const weg = profileOf('weg-drive');
const s7 = profileOf('s7-200');
const places = (profile: Profile, text: string) =>
  placesNamed(profile, text).map(({ table, address, name }) => [table, address, name]);

test.each(['P0683', 'p0683', ' P 0683 ', 'P0683 speed reference', 'p0683 Speed  Reference'])(
  'WEG: %s is holding register 683',
  (text) => {
    expect(places(weg, text)).toEqual([['holding-register', 683, 'P0683 speed reference']]);
  },
);

test.each(['VW804', 'VW 804', 'vw804'])('S7-200: %s is the third holding register, 2 from 0', (text) => {
  expect(places(s7, text)).toEqual([['holding-register', 2, 'VW804']]);
});

test.each([
  [weg, 'P06'],
  [weg, 'P0684'],
  [weg, 'speed'],
  [weg, ''],
  [weg, ' '],
  // A register begins at an even byte, and there are 1000 from VB800 on.
  [s7, 'VW805'],
  [s7, 'VW798'],
  [s7, 'VW2800'],
  [s7, 'VW'],
])('%# is no name', (profile, text) => {
  expect(places(profile, text)).toEqual([]);
});

test('a name that stands in two tables is found in both; the last in hexadecimal', () => {
  expect(places(profileOf('i-8xx7'), 'integer 3fff')).toEqual([['holding-register', 0x3fff, 'Integer 3FFF']]);
  expect(places(profileOf('i-8xx7'), 'Integer 3FFF by 04')).toEqual([['input-register', 0x3fff, 'Integer 3FFF by 04']]);
  const line = { ...plainRegister, name: 'T1', address: 5 };
  const both: Profile = {
    ...weg,
    registers: [
      { ...line, table: 'holding-register' },
      { ...line, table: 'input-register', address: 6 },
    ],
  };
  expect(places(both, 't1')).toEqual([
    ['holding-register', 5, 'T1'],
    ['input-register', 6, 'T1'],
  ]);
});

test('values of a line without a series have numbers; 32-bit ones are two registers apart', () => {
  const flow = { ...plainRegister, name: 'Flow', table: 'input-register', address: 10, type: 'f32', count: 3 } as const;
  const profile: Profile = { ...weg, registers: [flow] };
  expect(places(profile, 'flow [3]')).toEqual([['input-register', 14, 'Flow [3]']]);
  expect(places(profile, 'Flow')).toEqual([['input-register', 10, 'Flow [1]']]);
  expect(places(profile, 'Flow [4]')).toEqual([]);
  expect(places(profile, 'Flow [0]')).toEqual([]);
  // Enron and Daniel count each value once.
  expect(places(profileOf('enron-daniel'), 'Float 7002')).toEqual([['holding-register', 7002, 'Float 7002']]);
});

test('every value of the built-in devices is found by its name', () => {
  const lines = builtInProfiles.flatMap((profile) => profile.registers.map((register) => ({ profile, register })));
  fc.assert(
    fc.property(fc.constantFrom(...lines), fc.nat({ max: 0x3fff }), ({ profile, register }, at) => {
      // A text is one value, however many registers it has.
      const address = register.address + (isTextType(register.type) ? 0 : at % register.count);
      const name = nameAt(profile, register.table, address)!.split(', ')[0]!;
      expect(placesNamed(profile, name).map((place) => place.address)).toContain(address);
    }),
  );
});

test('any text is answered', () => {
  fc.assert(
    fc.property(fc.string(), fc.constantFrom(...builtInProfiles), (text, profile) => void placesNamed(profile, text)),
  );
});

const asked = (profile: Profile, name: string) =>
  readRequests(profile, profile.registers.find((register) => register.name === name)!).map(
    ({ functionCode, fields: { startAddress, quantity } }) => [functionCode, startAddress, quantity],
  );

test('a line longer than a request is read by several (AP 6.1, 6.3)', () => {
  // 1000 registers, 125 in a request.
  expect(asked(s7, 'VW{800+2n}')).toEqual([0, 125, 250, 375, 500, 625, 750, 875].map((first) => [3, first, 125]));
  // 16384 coils, 2000 in a request; 384 are left for the last.
  const coils = asked(profileOf('i-8xx7'), 'Boolean {0000h+1n}');
  expect(coils).toHaveLength(9);
  expect([coils[0], coils[1], coils[8]]).toEqual([
    [1, 0, 2000],
    [1, 2000, 2000],
    [1, 16000, 384],
  ]);
});

test('no value is cut in two by the end of a request', () => {
  // 62 values of two registers: 124 of the 125. By Enron's count the quantity is 62, and the reply has 248 bytes.
  const floats = asked(profileOf('enron-daniel'), 'Float {7001+1n}');
  expect(floats.slice(0, 2)).toEqual([
    [3, 7001, 62],
    [3, 7063, 62],
  ]);
  expect(floats.at(-1)).toEqual([3, 7993, 7]);
  const long = { ...plainRegister, name: 'E', table: 'holding-register', address: 0, type: 'f64', count: 40 } as const;
  const profile: Profile = { ...weg, registers: [long] };
  expect(asked(profile, 'E')).toEqual([
    [3, 0, 124],
    [3, 124, 36],
  ]);
  expect(readRequest(profile, long, 1).fields).toEqual({ startAddress: 4, quantity: 4 });
});
