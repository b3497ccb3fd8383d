import { expect, test } from 'vitest';
import { rawOf, readRequests } from '../../../src/devices/index.ts';
import {
  characterBits,
  crc,
  crc16,
  crcAdd,
  formatFraction,
  fraction,
  framesAt,
  hexDigits,
  lrc,
  nextPlace,
  orderName,
  receive,
  roundTo,
  sum8,
  toHex,
  writeValue,
  xor8,
} from '../../../src/modbus/index.ts';
import { formatBinary, formatHex } from '../../../src/notation/index.ts';
import { powersOf, ticksBetween, valueBytes } from '../../../src/workbench/index.ts';

const bytes = Uint8Array.of(1, 2, 3, 4);
const format = { dataBits: 8, parity: 'none', stopBits: 1 } as const;
const ccitt = { width: 16, poly: 0x1021, init: 0xffff, refin: false, refout: false, xorout: 0 } as const;
const profile = {
  id: '',
  name: '',
  source: '',
  convention: 'zero-based',
  traits: [],
  registers: [],
  notes: [],
} as const;
const register = {
  name: 'a',
  table: 'holding-register',
  address: 0,
  type: 'u16',
  order: 'ABCD',
  count: 1e9,
  factor: 1,
  offset: 0,
  unit: '',
  access: 'rw',
  names: [],
  description: '',
} as const;

test.each<readonly [string, () => unknown]>([
  ['an edge that is no time', () => receive([Number.NaN], { format, bit: 1 })],
  ['a bit of negative length', () => receive([0, 1, 5], { format, bit: -1 })],
  ['a bit of no length', () => receive([0, 1, 5], { format, bit: Number.NaN })],
  ['too many data bits', () => characterBits(1, { ...format, dataBits: 1e9 as 8 })],
  ['a text for too many registers', () => writeValue('ab', 'text', 'ABCD', { registers: 1e9 })],
  ['a text for -1 registers', () => writeValue('ab', 'text', 'ABCD', { registers: -1 })],
  ['CRC-16 beyond the bytes', () => crc16(bytes, 0, 1e9)],
  ['CRC-16 before the bytes', () => crc16(bytes, -1e9)],
  ['a CRC beyond the bytes', () => crc(ccitt, bytes, 0, 1e9)],
  ['a register beyond the bytes', () => crcAdd(ccitt, 0, bytes, Number.NEGATIVE_INFINITY)],
  ['LRC beyond the bytes', () => lrc(bytes, 0, 5)],
  ['SUM-8 beyond the bytes', () => sum8(bytes, -1)],
  ['xor beyond the bytes', () => xor8(bytes, 0, Number.NaN)],
  ['hexadecimal beyond the bytes', () => toHex(bytes, 0, Number.POSITIVE_INFINITY)],
  ['frames before the bytes', () => framesAt(bytes, -1e9)],
  ['a place before the bytes', () => nextPlace(bytes, Number.NEGATIVE_INFINITY, 'tcp')],
  ['digits without end', () => hexDigits(1, 1e9)],
  ['hexadecimal without end', () => formatHex(1, 1e9)],
  ['binary without end', () => formatBinary(1, 1e9)],
  ['decimals without end', () => formatFraction(fraction(1, 3), 1e9)],
  ['rounding to half a digit', () => roundTo(fraction(1, 3), 0.5)],
  ['a fraction of fractions', () => fraction(0.5)],
  ['an order of too many registers', () => orderName('ABCD', 1e9)],
  ['a mask of no bits', () => rawOf([1], { ...register, mask: 0 })],
  ['a mask of a list', () => rawOf([1], { ...register, mask: [1, 2] as unknown as number })],
  ['a register with too many values', () => readRequests(profile, register)],
  ['a polynomial of too many powers', () => powersOf({ width: 2 ** 53, poly: 7 })],
  ['a value of too many bytes', () => valueBytes(1, 1e9)],
  ['ticks without end', () => ticksBetween(0, 1e9, 1e-9)],
  ['ticks that do not move', () => ticksBetween(0, 1, 0)],
])('%s', (_what, call) => {
  expect(call).toThrow(RangeError);
});
