import { describe, expect, test } from 'vitest';
import { readPdu, said } from './frames.ts';

describe('a reply to Read File Record (AP 6.14)', () => {
  // File 4, record 1, 2 registers; file 3, record 9, 2 registers: the example of the specification.
  const request = [0x14, 0x0e, 6, 0, 4, 0, 1, 0, 2, 6, 0, 3, 0, 9, 0, 2];
  const first = [5, 6, 0x0d, 0xfe, 0x00, 0x20];
  const second = [5, 6, 0x33, 0xcd, 0x00, 0x40];

  test('has the groups that were asked for', () => {
    expect(said(readPdu('response', [0x14, 0x0c, ...first, ...second], request))).toEqual([]);
  });

  test.each([
    ['one group of two', [0x14, 0x06, ...first]],
    ['three groups', [0x14, 0x12, ...first, ...second, ...second]],
    ['more registers in a group', [0x14, 0x0e, ...first, 7, 6, 0x33, 0xcd, 0x00, 0x40, 0, 1]],
    ['one register in the first group and three in the second', [0x14, 0x0c, 3, 6, 1, 2, 7, 6, 1, 2, 3, 4, 5, 6]],
  ])('with %s is not the one that was asked for', (_, bytes) => {
    expect(said(readPdu('response', bytes, request))).toContain('error count-not-as-requested');
    expect(said(readPdu('response', bytes))).not.toContain('error count-not-as-requested');
  });
});

describe('a reply to Read Device Identification (AP 6.21)', () => {
  const reply = (code: number, ...ids: number[]) =>
    readPdu(
      'response',
      [0x2b, 0x0e, code, 0x83, 0, 0, ids.length, ...ids.flatMap((id) => [id, 1, 0x41])],
      [0x2b, 0x0e, 4, 1],
    );

  test('with individual access has the object that was asked for, and no other', () => {
    expect(said(reply(4, 1))).toEqual([]);
    expect(said(reply(4, 0))).toEqual(['error echo-differs']);
    expect(said(reply(4, 1, 2))).toEqual(['error echo-differs']);
  });

  test('at a lower level may have others', () => {
    expect(said(reply(1, 0, 1, 2))).toEqual(['note echo-differs']);
  });
});
