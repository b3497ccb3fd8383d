import { describe, expect, it } from 'vitest';
import { readOrderName, readTypeName } from '../../../../src/notation/index.ts';

/** What tables of makers and programs call a type, with the place where it is so called. */
const NAMES: Readonly<Record<string, readonly string[]>> = {
  u16: [
    ...['uint16', 'UINT', 'WORD', 'unsigned', 'Unsigned Word', '16-bit unsigned integer', 'UInt 16', 'ushort'],
    ...['U16', 'INT16U', 'U_WORD', 'enum16', 'acc16', '16uint', 'uint16_t', 'Unsigned 16 Bit', 'uint16be'],
  ],
  i16: ['int16', 'INT', 'short', 'S16', 'SINT16', 'S_WORD', 'INT16S', 'signed word', '16int', 'sunssf', 'Integer'],
  u32: ['uint32', 'UDINT', 'DWORD', 'INT32U', 'unsigned long', 'U_DWORD', 'acc32', 'enum32', 'uint32nan', '32uint'],
  i32: ['INT32', 'DINT', 'long', 'S32', 'Signed 32-bit integer', 'S_DWORD', 'INT32S', 'int32_t'],
  u64: ['uint64', 'ULINT', 'U_QWORD', 'acc64', 'QWORD', 'unsigned long long'],
  i64: ['int64', 'LINT', 'S_QWORD', 'LLong', 'signed 64 bit'],
  f32: [
    'float32',
    'REAL',
    'FP32',
    'Float',
    'single',
    'FLOAT32-IEEE',
    'IEEE 754 float',
    '32 bit float',
    'F32',
    '32float',
  ],
  f64: ['float64', 'double', 'LREAL', 'FP64'],
  bcd32: ['LBCD', 'BCD32'],
  bits: ['BOOL', 'bitfield16', 'Boolean', 'flags'],
  text: ['string', 'ASCII', 'char', 'STR'],
};

describe('names of types', () => {
  for (const [type, names] of Object.entries(NAMES)) {
    it.each(names)(`reads %s as ${type}`, (name) => {
      expect(readTypeName(name)?.type).toBe(type);
    });
  }

  it.each([
    ['U_DWORD_R', 'u32', 'CDAB'],
    ['FP32_R', 'f32', 'CDAB'],
    ['S_QWORD_R', 'i64', 'CDAB'],
    ['uint32sw', 'u32', 'CDAB'],
    ['uint32sb', 'u32', 'DCBA'],
    ['floatle', 'f32', 'DCBA'],
    ['doublebe', 'f64', 'ABCD'],
    ['int32s', 'i32', 'CDAB'],
    ['float32s', 'f32', 'CDAB'],
    ['FLOAT32 (CDAB)', 'f32', 'CDAB'],
    ['F32 word swap', 'f32', 'CDAB'],
    ['swapped float', 'f32', 'CDAB'],
    ['Float, big endian', 'f32', 'ABCD'],
  ])('reads the order in %s', (name, type, order) => {
    expect(readTypeName(name)).toMatchObject({ type, order });
  });

  it.each([
    ['STRING[8]', { type: 'text', count: 4 }],
    ['STRING(16)', { type: 'text', count: 8 }],
    ['char 20', { type: 'text', count: 10 }],
    ['text[4]', { type: 'text', count: 4 }],
    ['uint16[3]', { type: 'u16', count: 3 }],
    ['ARRAY[0..9] OF INT', { type: 'i16', count: 10 }],
    ['bool (bit 4)', { type: 'bits', bit: 4 }],
    ['Bit 3', { type: 'bits', bit: 3 }],
  ])('reads the length or the bit in %s', (name, said) => {
    expect(readTypeName(name)).toMatchObject(said);
  });

  it.each([
    ['INT', 2, 'i32'],
    ['INT', undefined, 'i16'],
    ['unsigned', 4, 'u64'],
    ['float', 4, 'f64'],
    ['INT32', 4, 'i32'],
    ['WORD', 2, 'u16'],
    ['signed', 1, 'i16'],
    ['Unsigned integer', 2, 'u32'],
  ])('takes %s of %s registers for %s', (name, registers, type) => {
    expect(readTypeName(name, registers)?.type).toBe(type);
  });

  it.each(['', 'Voltage', 'R/W', 'kWh', 'RO', 'holding', '3', '-', 'x'.repeat(100)])('does not read %j', (text) => {
    expect(readTypeName(text)).toBeUndefined();
  });
});

it.each([
  ['word swap', 'CDAB'],
  ['Word-Swapped', 'CDAB'],
  ['GHEFCDAB', 'CDAB'],
  ['BA', 'BADC'],
  ['Big Endian', 'ABCD'],
  ['CD AB', 'CDAB'],
  ['Low word first', 'CDAB'],
  ['MSW first', 'ABCD'],
  ['Little-endian', 'DCBA'],
  ['byte swap', 'BADC'],
])('reads the order %s', (name, order) => {
  expect(readOrderName(name)).toBe(order);
});
