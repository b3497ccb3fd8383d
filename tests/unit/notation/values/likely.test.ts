import { expect, test } from 'vitest';
import { plainTypeNames, type ValueType } from '../../../../src/modbus/index.ts';
import { findExpected, readExpected, valuesAt } from '../../../../src/notation/index.ts';

/** `f32 CDAB few-digits 77.5146` for each value that is marked. */
const marked = (registers: number[], expected = '') =>
  valuesAt(registers, readExpected(expected)).flatMap(({ type, order, text, likely }) =>
    likely ? [`${type} ${order} ${likely.code} ${text}`] : [],
  );

test('every type and order, as far as there are registers', () => {
  expect(valuesAt([])).toEqual([]);
  expect(valuesAt([4096]).map(({ type, order, text }) => `${type} ${order} ${text}`)).toEqual([
    'u16 ABCD 4096',
    'u16 BADC 16',
    'i16 ABCD 4096',
    'i16 BADC 16',
    'f16 ABCD 0.0004883',
    'f16 BADC 9.5e-7',
    'bcd16 ABCD 1000',
    'bcd16 BADC 0010',
    'bits ABCD 0001_0000_0000_0000',
    'bits BADC 0000_0000_0001_0000',
    'text ABCD ',
    'text BADC ',
  ]);
  const offered = (registers: readonly number[], type: ValueType) =>
    valuesAt(registers).flatMap((view) => (view.type === type ? view.order : []));
  expect(offered([1], 'u32')).toEqual([]);
  expect(offered([1, 2, 3], 'u32')).toEqual(['ABCD', 'CDAB', 'BADC', 'DCBA']);
  expect(offered([1, 2, 3], 'u64')).toEqual([]);
  expect(offered([1, 2, 3, 4], 'u64')).toEqual(['ABCD', 'CDAB', 'BADC', 'DCBA']);
  expect(new Set(valuesAt([1, 2, 3, 4]).map(({ type }) => type))).toEqual(new Set([...plainTypeNames, 'text']));
});

test('a float of few digits is marked in its order', () => {
  expect(marked([0x077a, 0x429b])).toContain('f32 CDAB few-digits 77.5146');
  expect(marked([0x2000, 0x447a])).toEqual(['f32 CDAB few-digits 1000.5']);
});

test('a printable text is marked', () => {
  expect(marked([0x5055, 0x4d50, 0x0000])).toContain('text ABCD printable "PUMP"');
  expect(marked([0x0102, 0x0304])).not.toContainEqual(expect.stringContaining('printable'));
});

test('an integer whose upper register is empty is marked once', () => {
  expect(marked([0x0000, 0x1000])).toEqual(['u32 ABCD small 4096', 'u32 BADC small 16']);
  expect(marked([0xffff, 0xfffb])).toContain('i32 ABCD small -5');
});

test('the expected number is found as typed, rounded, or in tenths', () => {
  expect(marked([0x077a, 0x429b], '77.5')).toContain('f32 CDAB expected-rounded 77.5146');
  expect(marked([0x077a, 0x429b], '77.5146')).toContain('f32 CDAB expected 77.5146');
  expect(marked([775], '77.5')).toEqual(['u16 ABCD expected-scaled 775', 'i16 ABCD expected-scaled 775']);
  expect(valuesAt([775], readExpected('77.5'))[0]?.likely).toEqual({ code: 'expected-scaled', power: 1 });
  expect(marked([0x1000], '0x1000')).toContain('u16 ABCD expected 4096');
  expect(marked([0x5055, 0x4d50], 'pump')).toContain('text ABCD expected "PUMP"');
  expect(marked([0x0001, 0x0000, 0x0000, 0x0001], '281474976710657')).toContain('u64 ABCD expected 281474976710657');
});

test('the expected value is found further on', () => {
  const expected = readExpected('77.5');
  const found = findExpected([1, 2, 0x077a, 0x429b, 0xffff], expected!);
  expect(found.map(({ at, view }) => `${at} ${view.type} ${view.order}`)).toEqual(['2 f32 CDAB']);
  expect(readExpected('  ')).toBeUndefined();
});

/** Where a rare value is found that was expected: `type order` for each. */
const found = (registers: number[], expected: string) =>
  findExpected(registers, readExpected(expected)!).map(({ at, view: { type, order } }) => `${at} ${type} ${order}`);

test.each<[string, number[], string, string]>([
  // Schneider, FAQ: 1,234,567 Wh as R1 + R2 × 10^4 + R3 × 10^8 + R4 × 10^12.
  ['modulo 10,000', [4567, 123, 0, 0], '1234567', '0 mod10k4 CDAB'],
  ['modulo 10,000, three registers', [4567, 123, 0], '1234567', '0 mod10k3 CDAB'],
  ['modulo 10,000, highest first', [123, 4567], '1234567', '0 mod10k2 ABCD'],
  ['a low byte', [0x191e], '30', '0 u8l ABCD'],
  ['a high byte', [0x191e], '25', '0 u8h ABCD'],
  ['a signed high byte', [0xd81e], '-40', '0 i8h ABCD'],
  ['an exponent and a mantissa', [65022, 7616], '-123.456', '0 e8m24 ABCD'],
  ['64 bits, pairs swapped', [0, 2, 0, 1], '4294967298', '0 u64 EFGHABCD'],
  ['64 bits, words swapped in pairs', [1, 0, 2, 0], '4294967298', '0 u64 CDABGHEF'],
  ['sign and magnitude', [0x8005], '-5', '0 sm16 ABCD'],
  ['signed BCD', [0xf123], '-123', '0 sbcd16 ABCD'],
  ['BCD of 64 bits', [0x1234, 0x5678, 0x9012, 0x3456], '1234567890123456', '0 bcd64 ABCD'],
  ['48 bits', [1, 0, 2], '4294967298', '0 u48 ABCD'],
  ['24 bits', [0xfd01, 2], '65538', '0 u24 ABCD'],
  ['a date of IEC 870-5-4', [0x001a, 0x0b3e, 0x0719, 12345], '2026-11-30 07:25', '0 timeiec ABCD'],
  ['a date with T', [0x3b9a, 0xca00], '2001-09-09T01:46:40Z', '0 timeunix ABCD'],
  ['an IPv4 address', [0xc0a8, 0x010a], '192.168.1.10', '0 ip ABCD'],
  ['a MAC address', [0x001a, 0x2b3c, 0x4d5e], '00:1a:2b:3c:4d:5e', '0 mac ABCD'],
  ['a power factor', [0x3fc0, 0], '0.5', '0 pf4q ABCD'],
  ['UTF-8', [19395, 48227, 26725], 'Küche', '0 text ABCD'],
  ['Latin-1', [0x4bfc, 0x6368, 0x6500], 'Küche', '0 latin1 ABCD'],
  ['a character a register', [0x50, 0x55, 0x4d, 0x50], 'PUMP', '0 chars ABCD'],
  ['a text with more behind its NUL', [16706, 17152, 30841], 'ABC', '0 text ABCD'],
])('%s is found', (_, registers, expected, where) => {
  expect(found(registers, expected)).toContain(where);
});

test('a rare type says nothing that a plain one has said, and nothing by itself', () => {
  // The low byte of 30 is 30, and so are 24 bits of it.
  expect(found([30], '30')).toEqual(['0 u16 ABCD', '0 i16 ABCD']);
  expect(marked([0x191e]).filter((each) => /u8|i8|sm16/.test(each))).toEqual([]);
  expect(found([0, 30], '30').filter((each) => each.startsWith('0'))).toEqual(['0 u32 ABCD', '0 i32 ABCD']);
});
