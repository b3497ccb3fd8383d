import { describe, expect, test } from 'vitest';
import {
  bitEffects,
  bitsPerCharacter,
  bitsTime,
  CrcSteps,
  characterBits,
  charactersTime,
  checksum,
  checksums,
  crc,
  crc16,
  crcAdd,
  crcCatalogue,
  crcChecksum,
  crcValue,
  edgesOf,
  exchangeTimes,
  fixedSilences,
  formatFraction,
  fraction,
  framesAt,
  hexDigits,
  type LineTimes,
  lineOf,
  lrc,
  maskedValue,
  masksFor,
  nextPlace,
  ownCrc,
  parityBit,
  pollingTime,
  polynomialForms,
  RtuScan,
  readValue,
  receive,
  residueOf,
  roundTo,
  rtuSilences,
  type SerialLine,
  sum8,
  toHex,
  twoTableStep,
  twoTables,
  writeValue,
  xor8,
} from '../../../src/modbus/index.ts';
import { hex } from './frames.ts';

const bytes = hex('11 03 00 6B 00 03 76 87');
const modbus = crcCatalogue.find(({ name }) => name === 'CRC-16/MODBUS')!;
const steps = new CrcSteps(modbus, bytes);
const line: SerialLine = { baud: 19_200, dataBits: 8, parity: 'even', stopBits: 1 };
const times: LineTimes = { lead: 5, silence: 38.5, delay: 50 };
const polling = {
  exchange: { request: 1, pause: 1, reply: 1, after: 1, total: 4 },
  devices: 2,
  missing: 1,
  timeout: 9,
};
const exchange = { mode: 'rtu', line, silences: fixedSilences, request: 8, reply: 8, delay: 1 } as const;
const width = (bits: number) => ({ ...modbus, width: bits });
/** A line that the types do not allow. */
const odd = (part: object): SerialLine => ({ ...line, ...part });

const NEVER = [Number.NaN, Infinity, -Infinity, -1, 1.5];
/** Of numbers that need not be whole. */
const NOT_FINITE = [Number.NaN, Infinity, -Infinity];
const TOO_MANY = 1e9;

/** What is given a number, and the numbers that it has no meaning for. */
const nonsense: Readonly<Record<string, readonly [(value: number) => unknown, readonly number[]]>> = {
  'crc16, from': [(from) => crc16(bytes, from), NEVER],
  'crc16, to': [(to) => crc16(bytes, 0, to), [...NOT_FINITE.slice(0, 2), 1.5, 9, TOO_MANY]],
  'crc, from': [(from) => crc(modbus, bytes, from), NEVER],
  'crc, to': [(to) => crc(modbus, bytes, 0, to), [Number.NaN, Infinity, 9, TOO_MANY]],
  'crc, width': [(bits) => crc(width(bits), bytes), [...NEVER, 0, 33, TOO_MANY]],
  'crcAdd, width': [(bits) => crcAdd(width(bits), 0, bytes), [...NEVER, 0, 33, TOO_MANY]],
  'crcValue, width': [(bits) => crcValue(width(bits), 0), [...NEVER, 0, 33, TOO_MANY]],
  'ownCrc, width': [(bits) => ownCrc('own', width(bits)), [...NEVER, 0, 33, TOO_MANY]],
  'residueOf, width': [(bits) => residueOf(width(bits)), [...NEVER, 0, 33, TOO_MANY]],
  'polynomialForms, width': [(bits) => polynomialForms(width(bits)), [...NEVER, 0, 33, TOO_MANY]],
  'crcChecksum, width': [(bits) => crcChecksum(width(bits)), [...NEVER, 0, 33, TOO_MANY]],
  'lrc, to': [(to) => lrc(bytes, 0, to), [Number.NaN, Infinity, 9, TOO_MANY]],
  'sum8, to': [(to) => sum8(bytes, 0, to), [Number.NaN, Infinity, 9, TOO_MANY]],
  'xor8, from': [(from) => xor8(bytes, from), NEVER],
  'toHex, to': [(to) => toHex(bytes, 0, to), [Number.NaN, Infinity, 9, TOO_MANY]],
  'every checksum, to': [
    (to) => {
      // The last one only is asked if all others throw.
      for (const of of checksums.slice(0, -1)) expect(() => checksum(of, bytes, 0, to), of.name).toThrow(RangeError);
      return checksum(checksums.at(-1)!, bytes, 0, to);
    },
    [Number.NaN, Infinity, 9, TOO_MANY],
  ],
  'join, size': [(size) => crcChecksum(modbus).join?.(1, 2, size), NEVER],
  'CrcSteps.byte': [(at) => steps.byte(at), [...NEVER, 8, TOO_MANY]],
  'CrcSteps.shifts': [(at) => steps.shifts(at), [...NEVER, 8, TOO_MANY]],
  'CrcSteps.split': [(at) => steps.split(at), [...NEVER, 8, TOO_MANY]],
  twoTableStep: [(at) => twoTableStep(twoTables(steps)!, steps, at), [...NEVER, 8, TOO_MANY]],
  'hexDigits, number': [(value) => hexDigits(value, 4), NEVER],
  'hexDigits, width': [(digits) => hexDigits(5, digits), [...NEVER, 65, TOO_MANY]],
  'framesAt, at': [(at) => framesAt(bytes, at), NEVER],
  'framesAt, end': [(end) => framesAt(bytes, 0, end), NEVER],
  'nextPlace, ASCII': [(from) => nextPlace(bytes, from, 'ascii'), NEVER],
  'nextPlace, TCP': [(from) => nextPlace(bytes, from, 'tcp'), NEVER],
  'RtuScan.next': [(from) => new RtuScan(bytes).next(from), NEVER],
  'RtuScan.begins': [(at) => new RtuScan(bytes).begins(at), NEVER],
  'RtuScan.endAt': [(at) => new RtuScan(bytes).endAt(at, 'request'), NEVER],
  'receive, bit': [(bit) => receive([0, 1, 5], { format: line, bit }), [...NOT_FINITE, 0, -1]],
  'receive, only edge': [(edge) => receive([edge], { format: line, bit: 1 }), NOT_FINITE],
  'receive, last edge': [(edge) => receive([0, 2, edge], { format: line, bit: 1 }), [...NOT_FINITE, 1]],
  'receive, data bits': [(dataBits) => receive([0, 1], { format: odd({ dataBits }), bit: 1 }), [...NEVER, 9, TOO_MANY]],
  'characterBits, data bits': [(dataBits) => characterBits(5, odd({ dataBits })), [...NEVER, 9, TOO_MANY]],
  'characterBits, stop bits': [(stopBits) => characterBits(5, odd({ stopBits })), [...NEVER, 0, 3, TOO_MANY]],
  'parityBit, data bits': [(dataBits) => parityBit(5, odd({ dataBits })), [...NEVER, 9, TOO_MANY]],
  'bitsPerCharacter, stop bits': [(stopBits) => bitsPerCharacter(odd({ stopBits })), [...NEVER, 0, 3, TOO_MANY]],
  'bitsPerCharacter, parity': [(parity) => bitsPerCharacter(odd({ parity })), [0]],
  'edgesOf, start': [
    (start) => edgesOf({ characters: [{ frame: 0, index: 0, value: 3, start, end: 11 }], format: line }),
    NOT_FINITE,
  ],
  'lineOf, lead': [(lead) => lineOf([{ bytes }], line, { ...times, lead }), NOT_FINITE],
  'lineOf, gap': [(length) => lineOf([{ bytes, gap: { after: 2, length } }], line, times), NOT_FINITE],
  'bitsTime, speed': [(baud) => bitsTime(baud, 1), [...NOT_FINITE, 0, -1]],
  'bitsTime, bits': [(bits) => bitsTime(9600, bits), [...NOT_FINITE, -1]],
  'charactersTime, number': [(characters) => charactersTime(line, characters), [...NOT_FINITE, -1]],
  'rtuSilences, speed': [(baud) => rtuSilences(baud, 11), [Number.NaN, -Infinity, 0, -1]],
  'exchangeTimes, delay': [(delay) => exchangeTimes({ ...exchange, delay }), [...NOT_FINITE, -1]],
  'exchangeTimes, reply': [(reply) => exchangeTimes({ ...exchange, reply }), [...NOT_FINITE, -1]],
  'pollingTime, devices': [(devices) => pollingTime({ ...polling, devices }), [...NOT_FINITE, -1, 0]],
  'pollingTime, timeout': [(timeout) => pollingTime({ ...polling, timeout }), [...NOT_FINITE, -1]],
  'readValue, register': [(register) => readValue([register], 'u16', 'ABCD'), [...NEVER, 0x10000, TOO_MANY]],
  'readValue, register of a text': [(register) => readValue([register], 'text', 'ABCD'), [...NEVER, 0x10000]],
  'writeValue, room': [(registers) => writeValue('ab', 'text', 'ABCD', { registers }), [...NEVER, 65_537, TOO_MANY]],
  masksFor: [(set) => masksFor(set, 0), [...NEVER, 0x10000]],
  maskedValue: [(current) => maskedValue(current, { andMask: 0, orMask: 0 }), [...NEVER, 0x10000]],
  bitEffects: [(andMask) => bitEffects({ andMask, orMask: 0 }), [...NEVER, 0x10000]],
  formatFraction: [(decimals) => formatFraction(fraction(1, 3), decimals), [...NEVER, 101, TOO_MANY]],
  roundTo: [(decimals) => roundTo(fraction(1, 3), decimals), [...NEVER, 101, TOO_MANY]],
};

describe('numbers that have no meaning throw a RangeError, and end', () => {
  test.each(Object.entries(nonsense))('%s', (_, [given, numbers]) => {
    for (const number of numbers) expect(() => given(number), String(number)).toThrow(RangeError);
  });
});

test('the numbers at the edge of these have one', () => {
  expect(crc16(bytes, 8)).toBe(0xffff);
  expect(toHex(bytes, 8, 8)).toBe('');
  expect(crc(width(1), bytes)).toBeLessThan(2);
  expect(crc(width(32), bytes)).toBeGreaterThan(0);
  expect(steps.byte(7).value).toBe(0x87);
  expect(hexDigits(0, 0)).toBe('0');
  expect(hexDigits(5, 64)).toHaveLength(64);
  expect(framesAt(bytes, 8)).toEqual([]);
  expect(nextPlace(bytes, 8, 'tcp')).toBe(8);
  expect(new RtuScan(bytes).next(0)).toBe(0);
  expect(receive([3, 3], { format: line, bit: 0.1 })).toEqual([]);
  expect(bitsTime(1, 0)).toBe(0);
  expect(pollingTime({ ...polling, devices: 1, timeout: 0 })).toBe(1);
  expect(readValue([0xffff], 'u16', 'ABCD')).toEqual({ kind: 'value', value: 0xffff });
  const text = writeValue('ab', 'text', 'ABCD', { registers: 65_536 });
  expect(text.kind === 'registers' && text.registers.length).toBe(65_536);
  expect(maskedValue(0xffff, { andMask: 0xffff, orMask: 0 })).toBe(0xffff);
  expect(formatFraction(fraction(1, 4), 100)).toHaveLength(102);
});
