import { expect, test } from 'vitest';
import { builtInProfiles, type Profile, plainRegister } from '../../../../src/devices/index.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { readLink } from '../../../../src/workbench/frame/link.ts';
import { bitsByByte } from '../../../../src/workbench/values/bits-by-byte.ts';
import { namedRows, rawBeside } from '../../../../src/workbench/values/named-rows.ts';

const framed = (link: string) => evaluate(readLink(link)!.draft).frame!;
const weg = builtInProfiles.find(({ id }) => id === 'weg-drive')!;

test('the values of a device have their names, units, raw numbers and bytes', () => {
  const { reading, bytes } = framed('#rtu/request?unitId=6&functionCode=6&address=0x02AB&value=4096');
  const [row, ...others] = namedRows(weg, reading, bytes);
  expect(others).toEqual([]);
  expect(row).toMatchObject({ from: 4, to: 6, value: { name: 'P0683 speed reference', raw: 4096, scaled: 30 } });
  expect(rawBeside(row!.value)).toBe(4096);
});

test('a value in two registers has the bytes of both, and one that is cut off those that there are', () => {
  const profile: Profile = {
    ...weg,
    registers: [
      { ...plainRegister, table: 'holding-register', address: 107, name: 'Flow', type: 'f32' },
      { ...plainRegister, table: 'holding-register', address: 109, name: 'Total', type: 'u32' },
    ],
  };
  const { reading, bytes } = framed(
    '#rtu/reply?unitId=17&functionCode=3&registers=0x42C8+0+7&answering=1103006B00037687',
  );
  expect(namedRows(profile, reading, bytes)).toMatchObject([
    { from: 3, to: 7, value: { name: 'Flow', raw: 100, cutOff: false } },
    { from: 7, to: 9, value: { name: 'Total', raw: undefined, cutOff: true } },
  ]);
  expect(namedRows(profile, reading, bytes).map(({ value }) => rawBeside(value))).toEqual([undefined, undefined]);
});

test('bits stand a byte a row, the lowest address first', () => {
  // AP 6.1: coils 20 to 38 (addresses 19 to 37) are CD 6B 05, of which the last has three.
  const { reading, bytes } = framed(
    '#rtu/reply?unitId=17&functionCode=1&bits=1011001111010110101&answering=110100130013 8E92',
  );
  expect(bitsByByte(reading, bytes)).toEqual([
    { first: 19, table: 'coil', bits: [1, 0, 1, 1, 0, 0, 1, 1], byte: 0xcd, from: 3, to: 4 },
    { first: 27, table: 'coil', bits: [1, 1, 0, 1, 0, 1, 1, 0], byte: 0x6b, from: 4, to: 5 },
    { first: 35, table: 'coil', bits: [1, 0, 1], byte: 0x05, from: 5, to: 6 },
  ]);
});
