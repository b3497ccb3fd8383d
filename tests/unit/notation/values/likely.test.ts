import { expect, test } from 'vitest';
import { numberTypeNames, type ValueType } from '../../../../src/modbus/index.ts';
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
  expect(new Set(valuesAt([1, 2, 3, 4]).map(({ type }) => type))).toEqual(new Set([...numberTypeNames, 'text']));
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
