import { describe, expect, it, test } from 'vitest';
import { readExpected, readValues, withPoints } from '../../../../src/notation/index.ts';

const plain = (text: string) => withPoints(text).text;
const noticed = (text: string) => withPoints(text).notices.map(({ place: _, ...notice }) => notice);

describe('a comma', () => {
  it.each([
    ['21,5', '21.5'],
    ['-1,5', '-1.5'],
    ['f32 21,5', 'f32 21.5'],
    ['21,5 °C', '21.5 °C'],
    ['21,5°C', '21.5°C'],
    ['21,5; 22,5', '21.5; 22.5'],
    ['f32 21,5\nf32 22,5', 'f32 21.5\nf32 22.5'],
    ['21,5 °C\n22,0 °C', '21.5 °C\n22.0 °C'],
  ])('is a decimal comma in %j', (text, read) => {
    expect(plain(text)).toBe(read);
  });

  it.each([
    '1,2,3',
    '1, 2',
    '21,5, 3',
    '1,2\n3,4',
    '0x15,5',
    '1,0x5',
    '1,5h',
    '1.5,2.5',
    'text "1,5"',
    ',5',
    '5,',
    '1,2,3; 4,5',
  ])('makes a list in %j', (text) => {
    expect(plain(text)).toBe(text);
    expect(withPoints(text).notices).toEqual([]);
  });

  it('is told, with the list and the whole number that it may be, which are then read so', () => {
    expect(noticed('21,5')).toEqual([{ code: 'decimal-comma', typed: '21,5', read: '21.5', list: '21, 5' }]);
    expect(noticed('f32 1,234')).toEqual([
      { code: 'decimal-comma', typed: '1,234', read: '1.234', list: 'f32 1, 234', whole: 'f32 1234' },
    ]);
    expect(readValues('21, 5').values.map(({ value }) => value)).toEqual([21, 5]);
    expect(readValues('f32 21,5')).toMatchObject({
      values: [{ value: 21.5, place: { start: 0, end: 8 } }],
      faults: [],
    });
  });
});

test('of two kinds of marks the last one is decimal', () => {
  expect(plain('f32 1.234,5')).toBe('f32 1234.5 ');
  expect(plain('1,234,567.25; 0,5')).toBe('1234567.25  ; 0.5');
  expect(noticed('1.234,5')).toEqual([{ code: 'decimal-comma', typed: '1.234,5', read: '1234.5', list: '1.234, 5' }]);
  expect(noticed('-1,234.5')).toMatchObject([{ code: 'grouped-digits', read: '-1234.5' }]);
  expect(readValues('f32 1.234,5')).toMatchObject({ values: [{ value: 1234.5 }], faults: [] });
});

test('a point before three digits may group them', () => {
  expect(noticed('1.000')).toEqual([{ code: 'grouped-digits', typed: '1.000', read: '1', whole: '1000' }]);
  expect(noticed('u32 12.500')).toMatchObject([{ code: 'grouped-digits', whole: 'u32 12500' }]);
  // Of a number with a fraction, three digits are as good as any.
  expect(noticed('f32 12.345')).toEqual([]);
  expect(noticed('0.25')).toEqual([]);
  expect(readValues('u32 1.234.567').values).toMatchObject([{ value: 1234567 }]);
});

test('hexadecimal of a signed type is its bits', () => {
  const value = (text: string) => readValues(text).values[0]?.value;
  expect(value('i16 0xFFFF')).toBe(-1);
  expect(value('i16 0x7FFF')).toBe(32767);
  expect(value('i32 0xFFFFFFFE')).toBe(-2);
  expect(value('i64 0xFFFFFFFFFFFFFFFF')).toBe(-1n);
  expect(value('i8l 0xD8')).toBe(-40);
  expect(value('i16 -1')).toBe(-1);
  expect(readValues('i16 0x10000').faults).toHaveLength(1);
  expect(readValues('i16 65535').faults).toHaveLength(1);
});

test('what is expected may have a unit, and a decimal comma', () => {
  const number = { kind: 'number', exactly: { numerator: 43n, denominator: 2n }, decimals: 1 };
  for (const text of ['21.5', '21,5', '21.5 °C', '21,5°C', ' 21.5 V ']) expect(readExpected(text)).toEqual(number);
  expect(readExpected('PUMP 5')).toEqual({ kind: 'text', text: 'PUMP 5' });
  expect(readExpected('"21.5 °C"')).toEqual({ kind: 'text', text: '21.5 °C' });
});
