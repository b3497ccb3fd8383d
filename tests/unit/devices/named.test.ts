import { expect, test } from 'vitest';
import { heldValue } from '../../../src/devices/codec.ts';
import {
  builtInProfiles,
  coilByteCount,
  deviceTraits,
  type NamedValue,
  nameAt,
  namedValues,
  type Profile,
  plainRegister,
  printedNumber,
  type Register,
  readRequest,
  readWithScale,
  searchProfile,
  writeRequest,
} from '../../../src/devices/index.ts';

const profile = (id: string): Profile => builtInProfiles.find((each) => each.id === id)!;
const weg = profile('weg-drive');
const s7 = profile('s7-200');
const icp = profile('i-8xx7');
const modicon = profile('modicon-984');
const enron = profile('enron-daniel');

const said = (values: readonly NamedValue[]) => values.map(({ name, raw, at }) => [name, raw, at]);

test.each<[Parameters<typeof heldValue>, unknown]>([
  // 77.5146 and 1000.5 with the words swapped, as two users had them.
  [[[0x077a, 0x429b], 'f32', 'CDAB'], Math.fround(77.5146)],
  [[[0x2000, 0x447a], 'f32', 'CDAB'], 1000.5],
  [[[0x447a, 0x2000], 'f32', 'ABCD'], 1000.5],
  [[[0x7a44, 0x0020], 'f32', 'BADC'], 1000.5],
  [[[0x0020, 0x7a44], 'f32', 'DCBA'], 1000.5],
  // A manual of a flow computer: 2,923,517,522 and 326,787.
  [[[0xae41, 0x5652], 'u32', 'ABCD'], 2923517522],
  [[[0x489f, 0x9060], 'f32', 'ABCD'], 326787],
  [[[0xffff, 0xffff, 0xffff, 0xfffe], 'i64', 'ABCD'], -2n],
  [[[0x0004, 0x0003, 0x0002, 0x0001], 'u64', 'CDAB'], 0x0001000200030004n],
  [[[0x3ff0, 0, 0, 0], 'f64', 'ABCD'], 1],
  [[[0x3c00], 'f16', 'ABCD'], 1],
  [[[0x0001], 'f16', 'ABCD'], 2 ** -24],
  [[[0xfc00], 'f16', 'ABCD'], Number.NEGATIVE_INFINITY],
  [[[0x1234], 'bcd16', 'ABCD'], 1234],
  [[[0x5678, 0x1234], 'bcd32', 'CDAB'], 12345678],
  [[[0x12a4], 'bcd16', 'ABCD'], undefined],
  [[[0x8000], 'i16', 'ABCD'], -32768],
  [[[0x5055, 0x4d50, 0x0000], 'text', 'ABCD'], 'PUMP'],
  [[[0x5550, 0x504d], 'text', 'BADC'], 'PUMP'],
])('%j', (given, value) => {
  expect(heldValue(...given)).toEqual(value);
});

test('WEG: the five rows of the guide, by number and in hertz', () => {
  const values = [0, 2048, 4096, 6144, 8192].map((raw) => namedValues(weg, 'holding-register', 683, [raw])[0]!);
  expect(values.map(({ name }) => name)).toEqual(Array(5).fill('P0683 speed reference'));
  expect(values.map(({ scaled }) => Number(scaled).toFixed(6))).toEqual([
    '0.000000',
    '15.000000',
    '30.000000',
    '45.000000',
    '60.000000',
  ]);
  const [, control, , direction] = namedValues(weg, 'holding-register', 681, [0xf000, 3, 4096, 7, 1]);
  expect(control).toMatchObject({ name: 'P0682 control word', at: 1, names: ['run', 'general enable'] });
  expect(direction).toMatchObject({ name: 'P0685 direction', at: 4, names: ['reverse'] });
});

test('S7-200: holding register n is VW(800 + 2(n − 1)), both ways', () => {
  // Registers 1, 2, 3 and 1000.
  expect([0, 1, 2, 999].map((address) => nameAt(s7, 'holding-register', address))).toEqual([
    'VW800',
    'VW802',
    'VW804',
    'VW2798',
  ]);
  expect(nameAt(s7, 'holding-register', 1000)).toBeUndefined();
  expect(searchProfile(s7, 'vw804')).toMatchObject([{ index: 2 }]);
  expect(searchProfile(s7, '40003')).toMatchObject([{ index: 2 }]);
  // A register begins at an even byte; VB798 is before the first.
  expect([searchProfile(s7, 'VW803'), searchProfile(s7, 'VW798'), searchProfile(s7, 'VW2800')]).toEqual([[], [], []]);
});

test('I-8xx7: network addresses, and its byte count', () => {
  // Its example: bytes 00 12 from 0x1020 are 0x1029 and 0x102C.
  const bits = [0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0];
  const on = namedValues(icp, 'coil', 0x1020, bits).filter(({ raw }) => raw === 1);
  expect(on.map(({ name }) => name)).toEqual(['Boolean 1029', 'Boolean 102C']);
  expect(nameAt(icp, 'holding-register', 0x3fff)).toBe('Integer 3FFF');
  expect(nameAt(icp, 'holding-register', 0x4000)).toBeUndefined();
  const counts = [1, 7, 8, 9, 15, 16];
  expect(counts.map((n) => coilByteCount(n, icp))).toEqual([1, 1, 2, 2, 2, 3]);
  expect(counts.map((n) => coilByteCount(n, { traits: [] }))).toEqual([1, 1, 1, 2, 2, 2]);
});

test('Modicon: five and six digits are the same register', () => {
  expect(nameAt(modicon, 'holding-register', 107)).toBe('40108, 400108');
  expect(nameAt(modicon, 'coil', 0)).toBe('00001, 000001');
  // Five digits end at address 9998.
  expect(nameAt(modicon, 'holding-register', 9998)).toBe('49999, 409999');
  expect(nameAt(modicon, 'holding-register', 9999)).toBe('410000');
  expect(nameAt(modicon, 'input-register', 65535)).toBe('365536');
});

test('Enron: 32-bit registers are counted one each', () => {
  const long = [0xae41, 0x5652, 0xffff, 0xffff, 0x0000];
  expect(said(namedValues(enron, 'holding-register', 5001, long))).toEqual([
    ['Long 5001', 2923517522 - 2 ** 32, 0],
    ['Long 5002', -1, 2],
    ['Long 5003', undefined, 4],
  ]);
  expect(readRequest(enron, searchProfile(enron, 'Float 7002')[0]!.register, 1)).toEqual({
    functionCode: 0x03,
    fields: { startAddress: 7002, quantity: 1 },
    force: {},
  });
  expect(writeRequest(enron, searchProfile(enron, 'Float 7002')[0]!.register, 1)).toEqual({
    functionCode: 0x10,
    fields: { startAddress: 7002, registers: [0, 0] },
    force: { quantity: 1 },
  });
});

const own = (register: Partial<Register>): [Profile, Register] => {
  const line: Register = { ...plainRegister, name: 'A', table: 'holding-register', address: 10, ...register };
  return [{ ...weg, registers: [line] }, line];
};

test('values that are cut off, begun before the list, or in lists of their own', () => {
  const [device] = own({ type: 'f32', count: 2 });
  expect(said(namedValues(device, 'holding-register', 10, [0x447a, 0x2000, 0]))).toEqual([
    ['A [1]', 1000.5, 0],
    ['A [2]', undefined, 2],
  ]);
  expect(said(namedValues(device, 'holding-register', 11, [0x2000, 0x447a, 0x2000]))).toEqual([['A [2]', 1000.5, 1]]);
  expect(namedValues(device, 'input-register', 10, [0, 0])).toEqual([]);
});

test.each<
  [string, Partial<Register>, number, Readonly<Record<string, unknown>>, number, Readonly<Record<string, unknown>>]
>([
  ['a register', {}, 0x03, { startAddress: 10, quantity: 1 }, 0x06, { address: 10, value: 0 }],
  ['a float', { type: 'f32' }, 0x03, { startAddress: 10, quantity: 2 }, 0x10, { startAddress: 10, registers: [0, 0] }],
  [
    'text',
    { type: 'text', count: 3 },
    0x03,
    { startAddress: 10, quantity: 3 },
    0x10,
    { startAddress: 10, registers: [0, 0, 0] },
  ],
  ['a coil', { table: 'coil', type: 'bits' }, 0x01, { startAddress: 10, quantity: 1 }, 0x05, { address: 10, value: 0 }],
  [
    'coils',
    { table: 'coil', type: 'bits', count: 2 },
    0x01,
    { startAddress: 10, quantity: 2 },
    0x0f,
    { startAddress: 10, bits: [0, 0] },
  ],
])('the requests for %s', (_what, parts, readCode, read, writeCode, write) => {
  const [device, line] = own(parts);
  expect(readRequest(device, line)).toEqual({ functionCode: readCode, fields: read, force: {} });
  expect(writeRequest(device, line)).toEqual({ functionCode: writeCode, fields: write, force: {} });
});

test('inputs are read by 02 and 04, and a request asks for no more than it may', () => {
  expect(readRequest(...own({ table: 'discrete-input', type: 'bits', count: 3000 })).fields).toEqual({
    startAddress: 10,
    quantity: 2000,
  });
  const inputs = readRequest(...own({ table: 'input-register', count: 300 }));
  expect(inputs).toMatchObject({ functionCode: 0x04, fields: { quantity: 125 } });
  expect(readRequest(...own({ table: 'discrete-input', type: 'bits' })).functionCode).toBe(0x02);
});

test('numbers as manuals print them', () => {
  const conventions = ['zero-based', 'one-based', 'five-digit', 'six-digit'] as const;
  expect(conventions.map((each) => printedNumber(each, 'holding-register', 107))).toEqual([
    '107',
    '108',
    '40108',
    '400108',
  ]);
  expect(printedNumber('five-digit', 'coil', 0)).toBe('00001');
});

test('a search is by words, by name, by address in decimal and hexadecimal, and by number', () => {
  const found = (text: string) => searchProfile(weg, text).map(({ register }) => register.address);
  expect([found('683'), found('0x2AB'), found('SPEED'), found('jog'), found('nothing'), found('')]).toEqual([
    [683],
    [683],
    [681, 682, 683],
    [682],
    [],
    [681, 682, 683, 685],
  ]);
});

test('a search finds what stands in any text of a line: name, description, unit, table and names of values', () => {
  const line: Register = { ...plainRegister, name: '', table: 'coil', address: 0 };
  const changes: readonly Partial<Register>[] = [
    { name: 'Xylem' },
    { description: 'the xylem' },
    { unit: 'xylem/s' },
    { names: [{ number: 1, name: 'Xylem on' }] },
  ];
  for (const change of changes) {
    const searched = { ...weg, registers: [line, { ...line, ...change }] };
    expect([change, searchProfile(searched, ' xYlem')]).toMatchObject([change, [{ register: change }]]);
  }
  const input: Register = { ...line, table: 'input-register' };
  expect(searchProfile({ ...weg, registers: [line, input] }, 'input-reg')).toEqual([
    { register: input, index: undefined },
  ]);
});

test('every trait stands in a built-in profile', () => {
  expect(new Set(builtInProfiles.flatMap((each) => each.traits))).toEqual(new Set(deviceTraits));
});

test('a line is read with its scale register where one request can, and the map has all between them', () => {
  const sunSpec = builtInProfiles.find(({ id }) => id === 'sunspec-inverter')!;
  const named = (name: string) => sunSpec.registers.find((register) => register.name === name)!;
  const read = (profile: Profile, register: Register) => readWithScale(profile, register).fields;
  // A at 40072, its scale register at 40076, and AphA to AphC between them.
  expect(read(sunSpec, named('A'))).toEqual({ startAddress: 40072, quantity: 5 });
  expect(read(sunSpec, named('W'))).toEqual({ startAddress: 40084, quantity: 2 });
  expect(read(sunSpec, named('ID'))).toEqual({ startAddress: 40070, quantity: 1 });
  const without = (name: string) => ({
    ...sunSpec,
    registers: sunSpec.registers.filter((register) => register.name !== name),
  });
  expect(read(without('AphB'), named('A'))).toEqual({ startAddress: 40072, quantity: 1 });
  const before = { ...named('W'), scaleRegister: { address: 40076 } };
  expect(read(sunSpec, before)).toEqual({ startAddress: 40076, quantity: 9 });
  expect(read(sunSpec, { ...named('W'), scaleRegister: { address: 40209 } })).toEqual({
    startAddress: 40084,
    quantity: 1,
  });
});
