import fc from 'fast-check';
import { expect, test } from 'vitest';
import {
  addressesOf,
  type EntityTable,
  entityTables,
  lineName,
  linesAt,
  nameAt,
  namedValues,
  type Profile,
  placesNamed,
  plainRegister,
  printedNumber,
  type Register,
  searchProfile,
  stepOf,
  valueName,
  valuesOf,
} from '../../../src/devices/index.ts';
import { indexOfName, isCalled } from '../../../src/devices/numbering.ts';
import { isTextType } from '../../../src/modbus/index.ts';
import { readNumber } from '../../../src/notation/index.ts';

/** Few names, many of them alike: codes, series with the same beginning or none, blanks, brackets, what is not a name. */
const names = [
  'P1',
  'p 1',
  'P1 speed',
  'P1 torque',
  'Speed',
  'speed [2]',
  'VW{0+2n}',
  'VW{4+2n}',
  'V W{0Ah+1n} x',
  '{0+1n}',
  '{40001+1n}',
  'İ{1+1n}',
  '[1]',
  ' ',
  '',
];
const asked = [...names, 'VW4', 'vw 6', 'VW0A x', 'vw0cX', '3', '40003', '40001', '400003', '2', '0x0003', 'P1[1]'];
const asks = fc.oneof(
  fc.constantFrom(...asked, 'speed[1]', 'Speed [2]', 'speed [2] [2]', 'i̇2', 'İ3', 'holding', 'V', 'note'),
  fc.string({ maxLength: 4 }),
);
const line: fc.Arbitrary<Register> = fc
  .record({
    name: fc.constantFrom(...names),
    table: fc.constantFrom(...entityTables),
    // Some lines lie close together, and some reach over all others.
    address: fc.oneof(fc.nat(30), fc.constantFrom(0, 40_000, 65_535)),
    count: fc.oneof(fc.integer({ min: 1, max: 6 }), fc.constantFrom(1, 100, 65_536)),
    type: fc.constantFrom<Register['type'][]>('u16', 'bits', 'f32', 'u64', 'text', 'u48'),
    description: fc.constantFrom('', 'A note'),
  })
  .map((some) => ({ ...plainRegister, ...some }));
const profiles: fc.Arbitrary<Profile> = fc.record({
  id: fc.constant('x'),
  name: fc.constant('x'),
  source: fc.constant(''),
  convention: fc.constantFrom('zero-based', 'one-based', 'five-digit', 'six-digit'),
  traits: fc.constantFrom([], ['one-address-each-value'] as const),
  registers: fc.array(line, { maxLength: 40 }),
  notes: fc.constant([]),
});
const addresses = fc.oneof(fc.integer({ min: 0, max: 40 }), fc.constantFrom(39_999, 40_000, 40_001, 65_535));

const plainLines = (profile: Profile, table: EntityTable, address: number) =>
  profile.registers.flatMap((register) => {
    const step = isTextType(register.type) ? register.count : stepOf(register, profile);
    const into = address - register.address;
    if (register.table !== table || into < 0 || into >= valuesOf(register) * step) return [];
    return [{ register, index: Math.floor(into / step), begins: into % step === 0 }];
  });

test('the lines at an address are those that a look at each line gives, for lines that overlap too', () => {
  fc.assert(
    fc.property(profiles, fc.constantFrom(...entityTables), addresses, (profile, table, address) => {
      const lines = plainLines(profile, table, address);
      expect(linesAt(profile, table, address)).toEqual(lines);
      const name = [...new Set(lines.map(({ register, index }) => valueName(register, index)))].join(', ');
      expect(nameAt(profile, table, address)).toBe(lines.length === 0 ? undefined : name);
    }),
  );
});

test('the same list of lines is found in a device that counts values, and in one that does not', () => {
  const registers: Register[] = [
    { ...plainRegister, name: 'A', table: 'holding-register', address: 0, type: 'f32', count: 2 },
    { ...plainRegister, name: 'B', table: 'holding-register', address: 2 },
  ];
  const profile: Profile = {
    ...{ id: '', name: '', source: '', convention: 'zero-based', traits: [], notes: [] },
    registers,
  };
  expect(nameAt(profile, 'holding-register', 2)).toBe('A [2], B');
  expect(nameAt({ ...profile, traits: ['one-address-each-value'] }, 'holding-register', 2)).toBe('B');
});

test('the values of a list are those that begin at its addresses', () => {
  fc.assert(
    fc.property(profiles, fc.constantFrom(...entityTables), addresses, fc.nat(12), (any, table, first, length) => {
      const profile = { ...any, traits: [] };
      const begin = Array.from({ length }, (_, at) => plainLines(profile, table, first + at)).flatMap((here, at) =>
        here.flatMap(({ register, index, begins }) => (begins ? [[register, valueName(register, index), at]] : [])),
      );
      const values = namedValues(profile, table, first, new Array(length).fill(0));
      expect(values.map(({ register, name, at }) => [register, name, at])).toEqual(begin);
    }),
  );
});

test('the places of a name are those that a look at each line gives', () => {
  fc.assert(
    fc.property(profiles, asks, (profile, text) => {
      const places = profile.registers.flatMap((register) => {
        const index = indexOfName(register, text) ?? (isCalled(register, text) ? 0 : undefined);
        if (text.trim() === '' || index === undefined) return [];
        const address = register.address + index * stepOf(register, profile);
        return [{ register, name: valueName(register, index), table: register.table, address }];
      });
      expect(placesNamed(profile, text)).toEqual(places);
    }),
  );
});

test('a search finds what a look at each line finds', () => {
  fc.assert(
    fc.property(profiles, asks, (profile, text) => {
      expect(searchProfile(profile, text)).toEqual(plainSearch(profile, text.trim().toLowerCase()));
    }),
  );
});

function plainSearch(profile: Profile, wanted: string) {
  const { convention } = profile;
  return profile.registers.flatMap((register) => {
    if (wanted === '') return [{ register, index: undefined }];
    const at = (address: number | undefined) => {
      const into = (address ?? Number.NaN) - register.address;
      if (!Number.isInteger(into) || into < 0 || into >= addressesOf(register, profile)) return undefined;
      return isTextType(register.type) ? 0 : Math.floor(into / stepOf(register, profile));
    };
    const number = Number(convention === 'one-based' ? wanted : wanted.slice(1)) - 1;
    const isPrinted =
      /^\d+$/.test(wanted) &&
      convention !== 'zero-based' &&
      printedNumber(convention, register.table, number) === wanted;
    const index = indexOfName(register, wanted) ?? (isPrinted ? at(number) : undefined) ?? at(readNumber(wanted));
    if (index !== undefined) return [{ register, index: valuesOf(register) === 1 ? undefined : index }];
    const says = [lineName(register), register.description, register.unit, register.table].join('\n').toLowerCase();
    return says.includes(wanted) ? [{ register, index: undefined }] : [];
  });
}
