import { describe, expect, test } from 'vitest';
import { decodeFrame, fromHex, partsOf, sectionOf, type Transport } from '../../../src/modbus/index.ts';

function parts(hex: string, transport: Transport, direction: 'request' | 'response', name: string) {
  const bytes = fromHex(hex)!;
  const reading = decodeFrame(bytes, { transport, direction });
  const span = reading.spans.find((candidate) => candidate.name === name)!;
  return partsOf(reading, bytes, span);
}

const places = (found: ReturnType<typeof parts>) => found.map(({ span }) => [span.from, span.to]);

describe('the items of a list field', () => {
  test('registers: two bytes each, with their values', () => {
    const found = parts('01 10 0001 0002 04 000A 0102 9230', 'rtu', 'request', 'registers');
    expect(places(found)).toEqual([
      [7, 9],
      [9, 11],
    ]);
    expect(found.map(({ values }) => values)).toEqual([{ value: 0x000a }, { value: 0x0102 }]);
  });

  test('bits: eight a byte, the last with those that count', () => {
    const found = parts('0F 0013 000A 02 CD01', 'pdu', 'request', 'bits');
    expect(found.map(({ values }) => values)).toEqual([{ value: [1, 0, 1, 1, 0, 0, 1, 1] }, { value: [1, 0] }]);
  });

  test('groups: each with its fields and their places', () => {
    const found = parts('14 0C 05 06 0DFE 0020 05 06 33CD 0040', 'pdu', 'response', 'subResponses');
    expect(places(found)).toEqual([
      [2, 8],
      [8, 14],
    ]);
    expect(found[1]?.parts.map(({ name, from, to }) => [name, from, to])).toEqual([
      ['fileResponseLength', 8, 9],
      ['referenceType', 9, 10],
      ['recordData', 10, 14],
    ]);
    expect(found[1]?.values).toEqual({ fileResponseLength: 5, referenceType: 6, recordData: [0x33cd, 0x0040] });
  });

  test('in ASCII places are characters', () => {
    const hex = Buffer.from(':11100001000204000A0102CB\r\n', 'latin1').toString('hex');
    expect(places(parts(hex, 'ascii', 'request', 'registers'))).toEqual([
      [15, 19],
      [19, 23],
    ]);
  });

  test('a field that is no list has none', () => {
    expect(parts('06 06 02AB 1000 F5E5', 'rtu', 'request', 'value')).toEqual([]);
  });
});

test('each part of a frame stands in its own section', () => {
  const reading = (hex: string, transport: Transport, direction: 'request' | 'response' = 'request') =>
    decodeFrame(fromHex(hex)!, { transport, direction });
  expect(sectionOf(reading('06 06 02AB 1000 F5E5', 'rtu'), 'unitId')).toBe('SL 2.2');
  expect(sectionOf(reading('06 06 02AB 1000 F5E5', 'rtu'), 'checksum')).toBe('SL 2.5.1.2');
  expect(sectionOf(reading('06 06 02AB 1000 F5E5', 'rtu'), 'address')).toBe('AP 6.6');
  expect(sectionOf(reading('0001 0000 0006 FF 03 0004 0001', 'tcp'), 'length')).toBe('TG 3.1.3');
  expect(sectionOf(reading('0001 0000 0006 FF 03 0004 0001', 'tcp'), 'unitId')).toBe('TG 4.4.1.2');
  expect(sectionOf(reading('2B 0E 01 00', 'pdu'), 'meiType')).toBe('AP 6.19');
  expect(sectionOf(reading('2B 0E 01 00', 'pdu'), 'objectId')).toBe('AP 6.21');
});
