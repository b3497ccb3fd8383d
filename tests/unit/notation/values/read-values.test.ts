import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { numberTypeNames, type Order, ordersOf, plainTypeNames, readValue } from '../../../../src/modbus/index.ts';
import { formatValue, formatValueHex, readFraction, readValues } from '../../../../src/notation/index.ts';

const registersOf = (text: string) => {
  const { values, faults } = readValues(text);
  expect(faults).toEqual([]);
  return values.flatMap(({ registers }) => registers);
};

const faultsOf = (text: string) => readValues(text).faults.map(({ fault }) => fault);

describe('typed values become registers', () => {
  test.each<[string, number[]]>([
    ['f32 CDAB 21.5', [0x0000, 0x41ac]],
    ['f32 CDAB 1000.5', [0x2000, 0x447a]],
    ['f32 CDAB 77.5146', [0x077a, 0x429b]],
    ['CDAB f32 77.5146', [0x077a, 0x429b]],
    ['u16 4096', [4096]],
    ['i32 -5', [0xffff, 0xfffb]],
    ['text "PUMP"', [0x5055, 0x4d50]],
    ['"PUMP"', [0x5055, 0x4d50]],
    ['text BA "PUMP"', [0x5550, 0x504d]],
    ['text[3] "PUMP"', [0x5055, 0x4d50, 0]],
    ['STRING(6) blank "PU"', [0x5055, 0x2020, 0x2020]],
    ['text "a, ""b"""', [0x612c, 0x2022, 0x6222]],
    // Lists without types are what they always were.
    ['1 2, 0x10\n16#FF', [1, 2, 16, 255]],
    ['u16 0x1000, i16 -1; bits 0000_0000_0000_1001', [0x1000, 0xffff, 9]],
    ['i16 1 -2 3', [1, 0xfffe, 3]],
    ['i16 −2', [0xfffe]],
    ['bcd 1234\nbcd32 12345678', [0x1234, 0x1234, 0x5678]],
    ['u64 18446744073709551615', [0xffff, 0xffff, 0xffff, 0xffff]],
    ['i64 GHEFCDAB 1', [1, 0, 0, 0]],
    ['f64 1', [0x3ff0, 0, 0, 0]],
    ['f16 1', [0x3c00]],
    // Names that manuals and programs use.
    ['REAL word swap 21.5', [0x0000, 0x41ac]],
    ['Modicon float 21.5', [0x0000, 0x41ac]],
    ['float big endian 21.5', [0x41ac, 0x0000]],
    ['float little-endian 21.5', [0x0000, 0xac41]],
    ['float Intel 21.5', [0x0000, 0xac41]],
    ['float byte swap 21.5', [0xac41, 0x0000]],
    ['float little-endian byte swap 21.5', [0x0000, 0x41ac]],
    ['float R1R0 21.5', [0x0000, 0x41ac]],
    ['float 3-2-1-0 21.5', [0x41ac, 0x0000]],
    ['DINT -5', [0xffff, 0xfffb]],
    ['UDINT R1 R0 65536', [0, 1]],
    ['LREAL -2', [0xc000, 0, 0, 0]],
    ['unsigned int 7', [7]],
    ['INT: 16', [16]],
    ['float = 1', [0x3f80, 0]],
    ['int 16', [16]],
    ['u32 1e5', [1, 0x86a0]],
    ['', []],
    [' ,;\n ', []],
  ])('%j', (text, registers) => {
    expect(registersOf(text)).toEqual(registers);
  });

  test('each value says its place', () => {
    const text = 'u16 1, f32 CDAB 21.5 22.5';
    const places = readValues(text).values.map(({ place }) => text.slice(place.start, place.end));
    expect(places).toEqual(['u16 1', '21.5', '22.5']);
  });
});

describe('what is said before', () => {
  const notesOf = (text: string) => readValues(text).values.flatMap(({ notes }) => notes);

  test('precision, NaN and infinities', () => {
    expect(notesOf('f32 16777217')).toEqual([{ code: 'precision-lost', typed: '16777217', stored: '16777216' }]);
    expect(notesOf('f16 77.5146')).toEqual([{ code: 'precision-lost', typed: '77.5146', stored: '77.5' }]);
    expect(notesOf('f32 3.14159265358979')).toEqual([
      { code: 'precision-lost', typed: '3.14159265358979', stored: '3.1415927' },
    ]);
    expect(notesOf('f64 9007199254740993')).toEqual([
      { code: 'precision-lost', typed: '9007199254740993', stored: '9007199254740992' },
    ]);
    expect(notesOf('f32 NaN, f64 -inf')).toEqual([
      { code: 'not-finite', typed: 'NaN' },
      { code: 'not-finite', typed: '-inf' },
    ]);
    expect(notesOf('f32 21.70, f32 -0, f32 1e-3, f64 0.1')).toEqual([]);
  });

  test('what does not fit', () => {
    expect(faultsOf('u16 65536')).toEqual([
      {
        code: 'refused',
        typed: '65536',
        type: 'u16',
        refusal: { kind: 'out-of-range', got: 65536, least: 0, most: 65535 },
      },
    ]);
    expect(faultsOf('u64 18446744073709551616')).toMatchObject([{ refusal: { got: 18446744073709551616n } }]);
    expect(faultsOf('f32 1e39')).toMatchObject([{ refusal: { kind: 'out-of-range' } }]);
    expect(faultsOf('f64 1e400')).toMatchObject([{ refusal: { kind: 'out-of-range' } }]);
    expect(faultsOf('u16 99999999999999999999')).toMatchObject([{ refusal: { kind: 'out-of-range' } }]);
    expect(faultsOf('i16 1.5')).toMatchObject([{ refusal: { kind: 'not-whole', got: 1.5 } }]);
    expect(faultsOf('u32 NaN')).toMatchObject([{ refusal: { kind: 'not-whole' } }]);
    expect(faultsOf('bcd 10000')).toMatchObject([{ refusal: { kind: 'out-of-range', most: 9999 } }]);
    expect(faultsOf('text[2] "PUMPS"')).toMatchObject([{ refusal: { kind: 'text-too-long', got: 5, most: 4 } }]);
    expect(faultsOf('latin1 "€"')).toMatchObject([{ refusal: { kind: 'no-character', character: '€' } }]);
    expect(faultsOf('ip 300.1.1.1')).toMatchObject([{ refusal: { kind: 'no-such-form', got: '300.1.1.1' } }]);
  });

  test('what is not a value', () => {
    // A comma with a blank makes a list, whose second number has no type.
    expect(faultsOf('f32 21, 5')).toEqual([{ code: 'type-missing', typed: '5' }]);
    expect(faultsOf('f32 CDAB')).toEqual([{ code: 'value-missing' }]);
    expect(faultsOf('flaot 1')).toEqual([{ code: 'name-unknown', name: 'flaot' }]);
    expect(faultsOf('f32 CADB 1')).toEqual([{ code: 'name-unknown', name: 'CADB' }]);
    expect(faultsOf('f32 0x41AC0000')).toEqual([{ code: 'hex-float', typed: '0x41AC0000' }]);
    expect(faultsOf('bcd 0x')).toEqual([{ code: 'not-a-value', typed: '0x', type: 'bcd16' }]);
    expect(faultsOf('text PUMP')).toEqual([{ code: 'text-unquoted', typed: 'PUMP' }]);
    expect(faultsOf('text "PUMP')).toEqual([{ code: 'quote-open' }]);
    expect(faultsOf('u16 "1"')).toEqual([{ code: 'not-a-value', typed: '"1"', type: 'u16' }]);
    const text = 'u16 1\nf32 x\n u16 2';
    expect(readValues(text)).toMatchObject({ faults: [{ place: { start: 10, end: 11 } }] });
    expect(readValues(text).values).toHaveLength(2);
  });
});

test.each(['__proto__', 'constructor', 'f32 toString'])('%s is not a value', (text) => {
  expect(readValues(text)).toMatchObject({ values: [], faults: [{ place: { end: text.length } }] });
});

test('any text is read without a throw, and a long one in few values', () => {
  fc.assert(
    fc.property(
      fc.oneof(fc.string(), fc.string({ unit: fc.constantFrom(...'u16f32 CDAB"[](),;\n-.0x1eE') })),
      (text) => {
        for (const { place } of readValues(text).values) expect(place.end).toBeGreaterThan(place.start);
      },
    ),
    { numRuns: 500 },
  );
  for (const piece of ['u16 1,', '"', '(', ' [', 'a', '1 ', 'u16 text ']) {
    const { values, faults } = readValues(piece.repeat(50_000));
    expect(values.length + faults.length).toBeLessThanOrEqual(50_000);
  }
});

test('what is formatted is read back, in every type and order', () => {
  const register = fc.nat(0xffff);
  const four = fc.tuple(register, register, register, register);
  fc.assert(
    fc.property(four, fc.constantFrom(...numberTypeNames), fc.nat(7), (registers, type, n) => {
      const order = (ordersOf(4) as Order[])[n]!;
      const read = readValue(registers, type, order);
      if (read.kind !== 'value') return;
      const text = `${type} ${order} ${formatValue(read.value, type)}`;
      const [again] = readValues(text).values;
      if (typeof read.value === 'bigint') expect(again?.value).toBe(read.value);
      if (Number.isNaN(read.value)) return;
      if (plainTypeNames.includes(type)) expect(again?.registers).toEqual(registers.slice(0, again?.registers.length));
      else expect(again?.value).toBe(read.value);
    }),
    { numRuns: 2000 },
  );
});

test('hexadecimal is the bits', () => {
  expect(formatValueHex(-5, 'i16')).toBe('0xFFFB');
  expect(formatValueHex(4096, 'u32')).toBe('0x00001000');
  expect(formatValueHex(-1n, 'i64')).toBe('0xFFFFFFFFFFFFFFFF');
});

test('fractions', () => {
  expect(readFraction('8192/60')).toEqual({ numerator: 2048n, denominator: 15n });
  expect(readFraction('-0.05')).toEqual({ numerator: -1n, denominator: 20n });
  expect(readFraction('1/-2')).toEqual({ numerator: -1n, denominator: 2n });
  for (const text of ['', '1/0', '1/2/3', 'x', '1/']) expect(readFraction(text)).toBeUndefined();
});
