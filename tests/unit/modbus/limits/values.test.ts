import { describe, expect, test } from 'vitest';
import type { Direction } from '../../../../src/modbus/index.ts';
import { readPdu, said, word } from '../frames.ts';

describe('a coil is FF00 or 0000 (AP 6.5)', () => {
  const coil = (value: number, direction: Direction) => said(readPdu(direction, [0x05, 0, 0, ...word(value)]));

  test.each(['request', 'response'] as const)('in a %s', (direction) => {
    for (const value of [0x0000, 0xff00]) expect(coil(value, direction)).toEqual([]);
    for (const value of [0x0001, 0x00ff, 0x0100, 0xff01, 0xffff, 0xfe00]) {
      expect(coil(value, direction)).toEqual(['error coil-value-illegal']);
    }
  });
});

describe('diagnostics (AP 6.8.1)', () => {
  const sub = (subFunction: number, ...data: number[]) => [0x08, ...word(subFunction), ...data];
  const request = (subFunction: number, ...data: number[]) => said(readPdu('request', sub(subFunction, ...data)));
  const response = (subFunction: number, ...data: number[]) => said(readPdu('response', sub(subFunction, ...data)));

  test.each([0x02, 0x04, 0x0a, 0x0b, 0x0c, 0x0d, 0x0e, 0x0f, 0x10, 0x11, 0x12, 0x14])('%i asks with 0000', (code) => {
    expect(request(code, 0, 0)).toEqual([]);
    expect(request(code, 0, 1)).toEqual(['error data-not-allowed']);
    expect(request(code, 0xff, 0)).toEqual(['error data-not-allowed']);
  });

  test('01 asks with 0000, or with FF00 to clear the log', () => {
    expect(request(1, 0, 0)).toEqual([]);
    expect(request(1, 0xff, 0)).toEqual([]);
    expect(request(1, 0, 0xff)).toEqual(['error data-not-allowed']);
  });

  test('01 is answered only outside listen only mode, 04 never', () => {
    expect(response(1, 0xff, 0)).toEqual(['note no-reply-in-listen-only']);
    expect(response(4, 0, 0)).toEqual(['error sub-function-without-reply']);
  });

  test('03 carries a character and 00', () => {
    for (const character of [0x00, 0x0a, 0x3b, 0xff]) expect(request(3, character, 0)).toEqual([]);
    expect(request(3, 0x3b, 0x01)).toEqual(['error data-not-allowed']);
  });

  test('00 carries any words, and how many is open', () => {
    expect(request(0, 0xa5, 0x37)).toEqual([]);
    expect(request(0, 1, 2, 3, 4)).toEqual(['note diagnostics-length-open']);
    expect(request(0, 1, 2, 3)).toContain('error data-length-odd');
  });

  test.each([0x02, 0x0b, 0x0c, 0x0d, 0x0e, 0x0f, 0x10, 0x11, 0x12])('%i answers with any count', (code) => {
    for (const count of [0, 1, 0xffff]) expect(response(code, ...word(count))).toEqual([]);
  });

  test.each([0x05, 0x06, 0x07, 0x08, 0x09, 0x16, 0x100, 0xffff])('%i is reserved, whatever it carries', (code) => {
    for (const data of [[], [0, 0], [1, 2, 3, 4]]) {
      expect(request(code, ...data)).toEqual(['warning sub-function-reserved']);
      expect(response(code, ...data)).toEqual(['warning sub-function-reserved']);
    }
  });

  test('13 and 15 are reserved in AP, though PI gives them rules', () => {
    expect(request(0x13, 0, 0)).toEqual(['warning sub-function-reserved']);
    expect(request(0x13, 0, 1)).toEqual(['warning sub-function-reserved', 'error data-not-allowed']);
    for (const operation of [3, 4]) expect(request(0x15, 0, operation)).toEqual(['warning sub-function-reserved']);
    expect(request(0x15, 0, 5)).toContain('error data-not-allowed');
  });
});

test.each([
  { what: 'event counter (AP 6.9)', before: [0x0b], after: [0, 0] },
  { what: 'event log (AP 6.10)', before: [0x0c, 6], after: [0, 0, 0, 0] },
])('the status of the $what is FFFF or 0000', ({ before, after }) => {
  const status = (value: number) => said(readPdu('response', [...before, ...word(value), ...after]));
  for (const value of [0x0000, 0xffff]) expect(status(value)).toEqual([]);
  for (const value of [0x0001, 0xff00, 0x00ff]) expect(status(value)).toEqual(['error value-not-allowed']);
});

describe('device identification (AP 6.21)', () => {
  const ask = (code: number, object: number) => said(readPdu('request', [0x2b, 0x0e, code, object]));
  const header = { code: 1, conformity: 1, more: 0, next: 0, number: 1 };
  const answer = (changed: Partial<typeof header>, object: readonly number[] = [0, 1, 0x41]) => {
    const { code, conformity, more, next, number } = { ...header, ...changed };
    return said(readPdu('response', [0x2b, 0x0e, code, conformity, more, next, number, ...object]));
  };

  test('the codes are 01 to 04', () => {
    for (const code of [1, 2, 3, 4]) expect(ask(code, 0)).toEqual([]);
    for (const code of [0, 5, 0xff]) expect(ask(code, 0)).toEqual(['error value-not-allowed']);
    for (const code of [0, 5]) expect(answer({ code })).toEqual(['error value-not-allowed']);
  });

  test('07 to 7F are reserved objects, 80 to FF private ones', () => {
    for (const object of [0x00, 0x06, 0x80, 0xff]) expect(ask(3, object)).toEqual([]);
    for (const object of [0x07, 0x7f]) expect(ask(3, object)).toEqual(['warning object-id-reserved']);
    expect(answer({}, [0x07, 1, 0x41])).toEqual(['warning object-id-reserved']);
  });

  test('the conformity level is 01 to 03 or 81 to 83', () => {
    for (const conformity of [1, 2, 3, 0x81, 0x82, 0x83]) expect(answer({ conformity })).toEqual([]);
    for (const conformity of [0, 4, 0x80, 0x84]) expect(answer({ conformity })).toEqual(['error value-not-allowed']);
  });

  test('more follows is 00 or FF; with 00 the next object is 00', () => {
    expect(answer({ more: 0xff, next: 5 })).toEqual([]);
    expect(answer({ more: 1 })).toEqual(['error value-not-allowed']);
    expect(answer({ next: 5 })).toEqual(['error next-object-not-zero']);
  });

  test('an object has at most 244 bytes, and may be empty', () => {
    const object = (length: number) => [0x80, length, ...new Array<number>(length).fill(0x41)];
    expect(answer({}, object(0))).toEqual([]);
    expect(answer({}, object(244))).toEqual([]);
    expect(answer({}, object(245))).toEqual(['error count-out-of-range', 'error pdu-too-long']);
  });
});

test('of the MEI types 0D and 0E are in use (AP 6.19, AP Annex A)', () => {
  expect(said(readPdu('request', [0x2b, 0x0d, 1, 2, 3]))).toEqual([]);
  for (const type of [0x00, 0x0c, 0x0f, 0xff]) {
    expect(said(readPdu('request', [0x2b, type, 1, 2]))).toEqual(['warning mei-type-reserved']);
    expect(said(readPdu('response', [0x2b, type, 1, 2]))).toEqual(['warning mei-type-reserved']);
  }
});
