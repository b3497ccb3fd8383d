import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  fromHex,
  type NumberTypeName,
  numberTypeNames,
  numberTypes,
  type Order,
  orderName,
  orders,
  ordersOf,
  plainTypeNames,
  readValue,
  shortestFloat,
  type Value,
  type ValueType,
  valueTypeNames,
  writeValue,
} from '../../../../src/modbus/index.ts';

/** Registers as their bytes travel: `07 7A 42 9B`. */
const wire = (hex: string): number[] => {
  const bytes = fromHex(hex.replaceAll(' ', ''))!;
  return Array.from({ length: bytes.length / 2 }, (_, index) => 256 * bytes[2 * index]! + bytes[2 * index + 1]!);
};

const allOrders = Object.keys(orders) as Order[];

const LITERAL: readonly (readonly [ValueType, Order, Value, string])[] = [
  // IEEE 754: 1000.5 is 447A2000, 123456 is 47F12000, 21.5 is 41AC0000.
  ['f32', 'CDAB', 1000.5, '20 00 44 7A'],
  ['f32', 'ABCD', 1000.5, '44 7A 20 00'],
  ['f32', 'BADC', 1000.5, '7A 44 00 20'],
  ['f32', 'DCBA', 1000.5, '00 20 7A 44'],
  ['f32', 'ABCD', 123456, '47 F1 20 00'],
  ['f32', 'CDAB', 21.5, '00 00 41 AC'],
  ['f32', 'CDAB', 77.5146, '07 7A 42 9B'],
  ['f64', 'ABCD', 1, '3F F0 00 00 00 00 00 00'],
  ['f64', 'CDAB', -2, '00 00 00 00 00 00 C0 00'],
  ['f16', 'ABCD', 1, '3C 00'],
  ['f16', 'BADC', -2, '00 C0'],
  ['f16', 'ABCD', 65504, '7B FF'],
  ['u16', 'ABCD', 4096, '10 00'],
  ['u16', 'BADC', 4096, '00 10'],
  ['i16', 'ABCD', -5, 'FF FB'],
  ['u32', 'ABCD', 0x01020304, '01 02 03 04'],
  ['u32', 'CDAB', 0x01020304, '03 04 01 02'],
  ['u32', 'BADC', 0x01020304, '02 01 04 03'],
  ['u32', 'DCBA', 0x01020304, '04 03 02 01'],
  ['i32', 'ABCD', -2, 'FF FF FF FE'],
  ['u64', 'ABCD', 0x0102030405060708n, '01 02 03 04 05 06 07 08'],
  ['u64', 'CDAB', 0x0102030405060708n, '07 08 05 06 03 04 01 02'],
  ['u64', 'BADC', 0x0102030405060708n, '02 01 04 03 06 05 08 07'],
  ['u64', 'DCBA', 0x0102030405060708n, '08 07 06 05 04 03 02 01'],
  ['u64', 'ABCD', 18446744073709551615n, 'FF FF FF FF FF FF FF FF'],
  ['i64', 'ABCD', -9223372036854775808n, '80 00 00 00 00 00 00 00'],
  ['i64', 'ABCD', 9007199254740993n, '00 20 00 00 00 00 00 01'],
  ['bcd16', 'ABCD', 1234, '12 34'],
  ['bcd32', 'CDAB', 12345678, '56 78 12 34'],
  ['bits', 'ABCD', 0b1000_0000_0000_0001, '80 01'],
  ['u8h', 'ABCD', 0x19, '19 00'],
  ['u8l', 'ABCD', 30, '00 1E'],
  ['i8h', 'ABCD', -40, 'D8 00'],
  ['i8l', 'ABCD', -1, '00 FF'],
  ['u24', 'ABCD', 0x010203, '00 01 02 03'],
  ['i24', 'CDAB', -2, 'FF FE 00 FF'],
  ['u48', 'ABCD', 0x010203040506, '01 02 03 04 05 06'],
  ['u48', 'CDAB', 0x010203040506, '05 06 03 04 01 02'],
  ['i48', 'DCBA', -2, 'FE FF FF FF FF FF'],
  ['sm16', 'ABCD', -5, '80 05'],
  ['sm32', 'CDAB', -5, '00 05 80 00'],
  ['sbcd16', 'ABCD', -123, 'F1 23'],
  ['sbcd32', 'ABCD', 1234567, '01 23 45 67'],
  ['bcd64', 'ABCD', 1234567890123456n, '12 34 56 78 90 12 34 56'],
  ['bits32', 'ABCD', 0x8000_0001, '80 00 00 01'],
  ['bits64', 'CDAB', 2n ** 63n, '00 00 00 00 00 00 80 00'],
  // Schneider, FAQ: R1 = 4567 and R2 = 123 are 1,234,567 Wh.
  ['mod10k4', 'CDAB', 1234567n, '11 D7 00 7B 00 00 00 00'],
  ['mod10k3', 'CDAB', 1234567, '11 D7 00 7B 00 00'],
  ['mod10k2', 'ABCD', -1234567, 'FF 85 EE 29'],
  ['e8m24', 'ABCD', -123.456, 'FD FE 1D C0'],
  ['u64', 'EFGHABCD', 4294967298n, '00 00 00 02 00 00 00 01'],
  ['u64', 'CDABGHEF', 4294967298n, '00 01 00 00 00 02 00 00'],
  ['u64', 'DCBAHGFE', 0x0102030405060708n, '04 03 02 01 08 07 06 05'],
  ['u64', 'FEHGBADC', 0x0102030405060708n, '06 05 08 07 02 01 04 03'],
  ['u32', 'CDABGHEF', 0x01020304, '03 04 01 02'],
  ['u32', 'EFGHABCD', 0x01020304, '01 02 03 04'],
  ['text', 'ABCD', 'Küche', '4B C3 BC 63 68 65'],
  ['text', 'ABCD', '温度 €', 'E6 B8 A9 E5 BA A6 20 E2 82 AC'],
  ['latin1', 'ABCD', 'Küche', '4B FC 63 68 65 00'],
  ['chars', 'ABCD', 'ABC', '00 41 00 42 00 43'],
  // Schneider, TI081: year, month and day with the day of the week (Monday, 1), hour and minute, milliseconds.
  ['timeiec', 'ABCD', '2026-11-30 07:25:12.345', '00 1A 0B 3E 07 19 30 39'],
  ['timeymd', 'ABCD', '2026-11-30 07:25:12', '1A 0B 1E 07 19 0C'],
  // PowerLogic: month and day, year since 1900 and hour, minute and second.
  ['timemdy', 'ABCD', '2004-02-29 23:59:58', '02 1D 68 17 3B 3A'],
  ['timebcd', 'ABCD', '2026-11-30 07:25:12', '26 11 30 07 25 12'],
  // RFC 3339 and `date -d @1000000000`: 2001-09-09 01:46:40 UTC.
  ['timeunix', 'ABCD', '2001-09-09 01:46:40Z', '3B 9A CA 00'],
  ['timeunix', 'CDAB', '2001-09-09 01:46:40Z', 'CA 00 3B 9A'],
  ['timeunix64', 'ABCD', '2106-02-07 06:28:16Z', '00 00 00 01 00 00 00 00'],
  ['timeunixms', 'ABCD', '2001-09-09 01:46:40.001Z', '00 00 00 E8 D4 A5 10 01'],
  ['ip', 'ABCD', '192.168.1.10', 'C0 A8 01 0A'],
  ['mac', 'ABCD', '00:1A:2B:3C:4D:5E', '00 1A 2B 3C 4D 5E'],
  // Schneider, PM5000: above 1 the factor is leading, 2 less the number; below −1, −2 less it.
  ['pf4q', 'ABCD', '0.5 lag', '3F 00 00 00'],
  ['pf4q', 'ABCD', '0.5 lead', '3F C0 00 00'],
  ['pf4q', 'ABCD', '-0.5 lead', 'BF C0 00 00'],
  ['pf4q', 'ABCD', '1', '3F 80 00 00'],
  ['text', 'ABCD', 'PUMP', '50 55 4D 50'],
  ['text', 'BADC', 'PUMP', '55 50 50 4D'],
  ['text', 'CDAB', 'PUMP', '50 55 4D 50'],
  ['text', 'ABCD', 'ABC', '41 42 43 00'],
];

describe('literal values', () => {
  test('of every type and in every order', () => {
    expect(new Set(LITERAL.map(([type]) => type))).toEqual(new Set(valueTypeNames));
    expect(new Set(LITERAL.map(([, order]) => order))).toEqual(new Set(allOrders));
  });

  test.each(LITERAL)('%s %s %s', (type, order, value, hex) => {
    expect(writeValue(value, type, order)).toMatchObject({ kind: 'registers', registers: wire(hex), exact: true });
    const read = readValue(wire(hex), type, order);
    // No f32 is 77.5146; the nearest one is read, and is shown as 77.5146.
    if (value === 77.5146) expect(read).toEqual({ kind: 'value', value: Math.fround(77.5146) });
    else expect(read).toEqual({ kind: 'value', value });
  });

  test('names of the orders for each width', () => {
    expect(ordersOf(1).map((order) => orderName(order, 1))).toEqual(['AB', 'BA']);
    expect(ordersOf(2).map((order) => orderName(order, 2))).toEqual(['ABCD', 'CDAB', 'BADC', 'DCBA']);
    expect(ordersOf(3).map((order) => orderName(order, 3))).toEqual(['ABCDEF', 'EFCDAB', 'BADCFE', 'FEDCBA']);
    expect(ordersOf(4).map((order) => orderName(order, 4))).toEqual([
      ...['ABCDEFGH', 'GHEFCDAB', 'BADCFEHG', 'HGFEDCBA'],
      ...['CDABGHEF', 'EFGHABCD', 'DCBAHGFE', 'FEHGBADC'],
    ]);
  });

  test('the shortest decimal', () => {
    const [f32] = [Math.fround(77.5146)];
    expect(shortestFloat(f32, 'f32')).toBe('77.5146');
    expect(shortestFloat(Math.fround(0.1), 'f32')).toBe('0.1');
    expect(shortestFloat(0.0999755859375, 'f16')).toBe('0.1');
    expect(shortestFloat(-0, 'f32')).toBe('-0');
    expect(shortestFloat(-Infinity, 'f16')).toBe('-Infinity');
    expect(shortestFloat(2 ** -149, 'f32')).toBe('1e-45');
  });
});

describe('what does not fit', () => {
  test.each<[Value, ValueType, object]>([
    [65536, 'u16', { kind: 'out-of-range', got: 65536, least: 0, most: 65535 }],
    [-1, 'u16', { kind: 'out-of-range', got: -1, least: 0, most: 65535 }],
    [32768, 'i16', { kind: 'out-of-range', least: -32768, most: 32767 }],
    [2 ** 32, 'u32', { kind: 'out-of-range', most: 4294967295 }],
    [-2147483649, 'i32', { kind: 'out-of-range', least: -2147483648 }],
    [2n ** 64n, 'u64', { kind: 'out-of-range', most: 18446744073709551615n }],
    [-(2n ** 63n) - 1n, 'i64', { kind: 'out-of-range', least: -9223372036854775808n }],
    [10000, 'bcd16', { kind: 'out-of-range', least: 0, most: 9999 }],
    [100000000, 'bcd32', { kind: 'out-of-range', most: 99999999 }],
    [65520, 'f16', { kind: 'out-of-range', least: -65504, most: 65504 }],
    [3.5e38, 'f32', { kind: 'out-of-range' }],
    [1.5, 'u16', { kind: 'not-whole', got: 1.5 }],
    [Number.NaN, 'i32', { kind: 'not-whole' }],
    [Infinity, 'u64', { kind: 'not-whole' }],
    ['a€', 'latin1', { kind: 'no-character', character: '€', at: 1 }],
    ['\ud800', 'text', { kind: 'no-character', at: 0 }],
    [1000, 'sbcd16', { kind: 'out-of-range', least: -999, most: 999 }],
    [-32768, 'sm16', { kind: 'out-of-range', least: -32767, most: 32767 }],
    [256, 'u8l', { kind: 'out-of-range', least: 0, most: 255 }],
    [100000000, 'mod10k2', { kind: 'out-of-range', most: 99999999 }],
    [Number.NaN, 'e8m24', { kind: 'out-of-range' }],
    ['2026-02-30 00:00', 'timeiec', { kind: 'no-such-form' }],
    ['1999-12-31 00:00', 'timeymd', { kind: 'no-such-form' }],
    ['1969-12-31 00:00', 'timeunix', { kind: 'no-such-form' }],
    ['256.0.0.1', 'ip', { kind: 'no-such-form' }],
    ['00:1A', 'mac', { kind: 'no-such-form' }],
    ['1.5', 'pf4q', { kind: 'no-such-form' }],
  ])('%s as %s', (value, type, said) => {
    expect(writeValue(value, type, 'ABCD')).toMatchObject(said);
  });

  test('a float that is held nearly says what is held', () => {
    expect(writeValue(16777217, 'f32', 'ABCD')).toEqual({
      kind: 'registers',
      registers: wire('4B 80 00 00'),
      exact: false,
      stored: 16777216,
    });
    expect(writeValue(77.5146, 'f16', 'ABCD')).toMatchObject({ exact: false, stored: 77.5 });
    // Half a step below the overflow still rounds to the largest.
    expect(writeValue(65519, 'f16', 'ABCD')).toMatchObject({ registers: [0x7bff], exact: false, stored: 65504 });
    expect(writeValue(1e-50, 'f32', 'ABCD')).toMatchObject({ registers: [0, 0], exact: false, stored: 0 });
    expect(writeValue(9007199254740993n, 'f64', 'ABCD')).toMatchObject({ exact: false, stored: 9007199254740992 });
    expect(writeValue(21.7, 'f32', 'ABCD')).toMatchObject({ exact: true });
  });

  test('NaN and infinities are floats', () => {
    expect(writeValue(Number.NaN, 'f32', 'ABCD')).toMatchObject({ registers: wire('7F C0 00 00'), exact: true });
    expect(writeValue(-Infinity, 'f32', 'CDAB')).toMatchObject({ registers: wire('00 00 FF 80'), exact: true });
    expect(writeValue(Infinity, 'f16', 'ABCD')).toMatchObject({ registers: [0x7c00] });
    expect(readValue(wire('7F C0 00 00'), 'f32', 'ABCD')).toEqual({ kind: 'value', value: Number.NaN });
  });

  test('too few registers, a digit above 9, what is no date, bytes that are not UTF-8', () => {
    expect(readValue([1], 'u32', 'ABCD')).toEqual({ kind: 'too-few-registers', got: 1, needed: 2 });
    expect(readValue([0x12a4], 'bcd16', 'ABCD')).toEqual({ kind: 'no-value' });
    expect(readValue([0xa123], 'sbcd16', 'ABCD')).toEqual({ kind: 'no-value' });
    expect(readValue([10000, 0], 'mod10k2', 'ABCD')).toEqual({ kind: 'no-value' });
    expect(readValue([26, 0x0d1e, 0, 0], 'timeiec', 'ABCD')).toEqual({ kind: 'no-value' });
    expect(readValue([0x2613, 0x3007, 0x2512], 'timebcd', 'ABCD')).toEqual({ kind: 'no-value' });
    expect(readValue([0x4040, 0], 'pf4q', 'ABCD')).toEqual({ kind: 'no-value' });
    expect(readValue([0x41c4], 'text', 'ABCD')).toEqual({ kind: 'not-text', byte: 0xc4, at: 1 });
    // A longer form than needed, a surrogate, and a character that is cut off.
    for (const words of [[0xc0af], [0xeda0, 0x8041], [0x41e2, 0x8241]])
      expect(readValue(words, 'text', 'ABCD').kind).toBe('not-text');
  });

  test('the parts that are not its own are no part of a value', () => {
    expect(readValue([0x191e], 'u8l', 'ABCD')).toEqual({ kind: 'value', value: 30 });
    expect(readValue([0x191e], 'u8h', 'ABCD')).toEqual({ kind: 'value', value: 25 });
    expect(readValue([0xfd01, 2], 'u24', 'ABCD')).toEqual({ kind: 'value', value: 0x10002 });
    // The weekday and the bits of validity.
    expect(readValue([0xff9a, 0x0b3e, 0x8799, 0], 'timeiec', 'ABCD')).toMatchObject({ value: '2026-11-30 07:25:00' });
  });

  test('a text ends at its first NUL', () => {
    expect(readValue([0x4142, 0x4300, 0x7879, 0x7a00], 'text', 'ABCD')).toEqual({ kind: 'value', value: 'ABC' });
    expect(readValue([0x0041, 0x0042, 0, 0x0043], 'chars', 'ABCD')).toEqual({ kind: 'value', value: 'AB' });
  });

  test('a text in its room', () => {
    expect(writeValue('AB', 'text', 'ABCD', { registers: 2 })).toMatchObject({ registers: [0x4142, 0] });
    expect(writeValue('A', 'text', 'BADC', { registers: 2, padding: 'blank' })).toMatchObject({
      registers: [0x2041, 0x2020],
    });
    expect(writeValue('ABCDE', 'text', 'ABCD', { registers: 2 })).toEqual({ kind: 'text-too-long', got: 5, most: 4 });
    expect(readValue([0x4120, 0x2020], 'text', 'ABCD', 'blank')).toEqual({ kind: 'value', value: 'A' });
    expect(readValue([0x4120, 0x2020], 'text', 'ABCD')).toEqual({ kind: 'value', value: 'A   ' });
  });

  test('a string is not a number, and a number no text', () => {
    expect(() => writeValue('1', 'u16', 'ABCD')).toThrow(TypeError);
    expect(() => writeValue(1, 'text', 'ABCD')).toThrow(TypeError);
  });
});

/** Any value of a type. */
function valuesOf(type: NumberTypeName): fc.Arbitrary<Value> {
  const { kind, registers, least, most } = numberTypes[type];
  if (type === 'e8m24')
    return fc
      .tuple(fc.integer({ min: -0x7f_ffff, max: 0x7f_ffff }), fc.integer({ min: -128, max: 127 }))
      .map(([number, power]) => Number(`${number}e${power}`) + 0);
  if (kind === 'float') {
    const register = fc.nat(0xffff);
    // Any bits; what they say is read by the platform, not by us, but for binary16, which has its own test.
    return fc.array(register, { minLength: registers, maxLength: registers }).map((words) => {
      const view = new DataView(new ArrayBuffer(8));
      for (const [index, word] of words.entries()) view.setUint16(2 * index, word);
      return type === 'f64' ? view.getFloat64(0) : type === 'f32' ? view.getFloat32(0) : (words[0]! - 32768) / 64;
    });
  }
  return registers === 4
    ? fc.bigInt(BigInt(least), BigInt(most))
    : fc.maxSafeInteger().map((any) => Number(least) + (Math.abs(any) % (Number(most) - Number(least) + 1)));
}

describe('written values are read back', () => {
  test.each(numberTypeNames)('%s in every order', (type) => {
    fc.assert(
      fc.property(valuesOf(type), fc.constantFrom(...allOrders), (value, order) => {
        const written = writeValue(value, type, order);
        if (written.kind !== 'registers') throw new Error(written.kind);
        const read = readValue(written.registers, type, order);
        const isSame = !written.exact || type === 'f16' || (read.kind === 'value' && Object.is(read.value, value));
        if (written.registers.length !== numberTypes[type].registers || read.kind !== 'value' || !isSame)
          expect({ written, read }).toEqual({ registers: numberTypes[type].registers, value });
      }),
      { numRuns: 300 },
    );
  });

  test('texts', () => {
    const ascii = fc.string({ unit: fc.integer({ min: 1, max: 0x7f }).map((code) => String.fromCharCode(code)) });
    fc.assert(
      fc.property(ascii, fc.constantFrom(...allOrders), fc.nat(5), (value, order, more) => {
        const written = writeValue(value, 'text', order, { registers: Math.ceil(value.length / 2) + more });
        if (written.kind !== 'registers') throw new Error(written.kind);
        expect(readValue(written.registers, 'text', order)).toEqual({ kind: 'value', value });
      }),
    );
  });

  test('the shortest decimal of any f32 is the f32 again, and never longer than nine digits', () => {
    fc.assert(
      fc.property(fc.float({ noNaN: true }), (value) => {
        const text = shortestFloat(value, 'f32');
        expect(Math.fround(Number(text))).toBe(value);
        expect(text.replace(/e.*$|[-.]|Infinity/g, '').replace(/^0+|0+$/g, '').length).toBeLessThanOrEqual(9);
      }),
      { numRuns: 1000 },
    );
  });
});

/** Types whose numbers each stand in one way in their registers, and take all of these. */
const unique = [...plainTypeNames, 'bits32', 'bits64', 'bcd64', 'u48', 'i48'] as const;

test('any registers, read and written, are the same registers, in every such type and order', () => {
  const register = fc.nat(0xffff);
  const wrong: unknown[] = [];
  fc.assert(
    fc.property(fc.tuple(register, register, register, register), (four) => {
      for (const type of unique) {
        for (const order of allOrders) {
          const read = readValue(four, type, order);
          // A digit above 9 is not a number, and of a NaN only that it is one is kept.
          if (read.kind !== 'value' || Number.isNaN(read.value)) continue;
          const written = writeValue(read.value, type, order);
          const taken = four.slice(0, numberTypes[type].registers);
          if (written.kind !== 'registers' || !written.exact || String(written.registers) !== String(taken)) {
            wrong.push([type, order, four]);
          }
        }
      }
      expect(wrong).toEqual([]);
    }),
    { numRuns: 300 },
  );
});

test('all 65,536 bit patterns of f16', { timeout: 60_000 }, () => {
  // Worked out by the definition of IEEE 754 binary16, term by term.
  const wrong: number[] = [];
  for (let bits = 0; bits < 0x10000; bits++) {
    const text = bits.toString(2).padStart(16, '0');
    const exponent = Number.parseInt(text.slice(1, 6), 2);
    const fraction = Array.from(text.slice(6)).reduce((sum, bit, index) => sum + Number(bit) * 2 ** -(index + 1), 0);
    const size =
      exponent === 31
        ? fraction === 0
          ? Infinity
          : Number.NaN
        : exponent === 0
          ? fraction * 2 ** -14
          : (1 + fraction) * 2 ** (exponent - 15);
    const value = text.startsWith('1') ? -size : size;
    const read = readValue([bits], 'f16', 'ABCD');
    const written = writeValue(value, 'f16', 'ABCD');
    const back = Number.isNaN(value) ? 0x7e00 : bits;
    const same = read.kind === 'value' && Object.is(read.value, value);
    const exact = written.kind === 'registers' && written.exact && written.registers[0] === back;
    const text16 = shortestFloat(value, 'f16');
    const again = writeValue(Number(text16), 'f16', 'ABCD');
    const shortest = again.kind === 'registers' && again.registers[0] === back;
    if (!same || !exact || !shortest) wrong.push(bits);
  }
  expect(wrong).toEqual([]);
});

test('a number between two f16 goes to the nearer, and from the middle to the even one', () => {
  const written = (value: number) => writeValue(value, 'f16', 'ABCD');
  // 1 is 3C00, and the next are 1 + 1/1024 and 1 + 2/1024.
  expect(written(1 + 1 / 2048)).toMatchObject({ registers: [0x3c00], stored: 1 });
  expect(written(1 + 3 / 2048)).toMatchObject({ registers: [0x3c02] });
  expect(written(1 + 1.001 / 2048)).toMatchObject({ registers: [0x3c01] });
  // The smallest is 2^-24; half of it goes to 0.
  expect(written(2 ** -25)).toMatchObject({ registers: [0], stored: 0 });
  expect(written(1.5 * 2 ** -25)).toMatchObject({ registers: [1] });
  // A carry goes into the exponent: 2047.9 rounds to 2048.
  expect(written(2047.9)).toMatchObject({ registers: [0x6800], stored: 2048 });
});
