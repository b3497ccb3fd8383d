import { describe, expect, test } from 'vitest';
import { readPdu, said, word, zeros } from '../frames.ts';

interface Group {
  readonly type?: number;
  readonly file?: number;
  readonly record?: number;
  readonly length?: number;
}

const group = ({ type = 6, file = 1, record = 0, length = 1 }: Group) => [
  type,
  ...word(file),
  ...word(record),
  ...word(length),
];
const repeat = (times: number, bytes: readonly number[]) => new Array(times).fill(bytes).flat() as number[];

describe('0x14 asks (AP 6.14)', () => {
  const ask = (...groups: Group[]) => {
    const bytes = groups.flatMap(group);
    return said(readPdu('request', [0x14, bytes.length, ...bytes]));
  };

  test('reference type 06', () => {
    expect(ask({})).toEqual([]);
    for (const type of [0, 5, 7]) expect(ask({ type })).toEqual(['error value-not-allowed']);
  });

  test('file 1 to FFFF, above 10 with a note', () => {
    for (const file of [1, 10]) expect(ask({ file })).toEqual([]);
    for (const file of [11, 0xffff]) expect(ask({ file })).toEqual(['note file-number-high']);
    expect(ask({ file: 0 })).toEqual(['error value-out-of-range']);
  });

  test('record 0 to 9999', () => {
    for (const record of [0, 9999]) expect(ask({ record })).toEqual([]);
    for (const record of [10000, 0xffff]) expect(ask({ record })).toEqual(['error value-out-of-range']);
  });

  test('no more than a reply of 253 bytes can hold', () => {
    // 253 = function code, data length, then for one group length, reference type and 2 × 124 bytes, and one to spare.
    expect(ask({ length: 124 })).toEqual([]);
    expect(ask({ length: 125 })).toEqual(['error reply-too-long']);
    // Two groups: 2 + 2 × 2 + 2 × (62 + 61) = 252.
    expect(ask({ length: 62 }, { length: 61 })).toEqual([]);
    expect(ask({ length: 62 }, { length: 62 })).toEqual(['error reply-too-long']);
  });

  test('1 to 35 groups of seven bytes', () => {
    const groups = (number: number) =>
      said(readPdu('request', [0x14, 7 * number, ...repeat(number, group({ length: 1 }))]));
    expect(groups(1)).toEqual([]);
    expect(groups(35)).toEqual([]);
    expect(groups(36)).toContain('error count-out-of-range');
    expect(groups(0)).toContain('error count-out-of-range');
  });

  test('a byte count that is no multiple of seven leaves a rest', () => {
    expect(said(readPdu('request', [0x14, 8, ...group({}), 0]))).toEqual(['error pdu-rest']);
    expect(said(readPdu('request', [0x14, 6, ...group({}).slice(0, 6)]))).toEqual([
      'error count-out-of-range',
      'error pdu-rest',
    ]);
  });
});

describe('0x14 answers (AP 6.14)', () => {
  const answer = (...groups: number[][]) => {
    const bytes = groups.flat();
    return said(readPdu('response', [0x14, bytes.length, ...bytes]));
  };

  test('the table starts at 07, the example has 05: below 07 there is a note', () => {
    expect(answer([0x03, 6, 0, 0])).toEqual(['note count-table-differs']);
    expect(answer([0x05, 6, 0, 0, 0, 0])).toEqual(['note count-table-differs']);
    expect(answer([0x07, 6, ...zeros(6)])).toEqual([]);
    expect(answer([0xf9, 6, ...zeros(248)])).toEqual([]);
  });

  test('reference type 06', () => {
    expect(answer([0x07, 5, ...zeros(6)])).toEqual(['error value-not-allowed']);
  });

  test('a group is its own length, and that is odd: a type and whole registers', () => {
    expect(answer([0x08, 6, ...zeros(7)])).toEqual(['error pdu-rest']);
    expect(answer([0x0b, 6, ...zeros(6)])).toContain('error pdu-rest');
    expect(answer([0x00, 6, ...zeros(6)])).toContain('error pdu-rest');
  });
});

describe.each(['request', 'response'] as const)('0x15 (AP 6.15), %s', (direction) => {
  const write = (...groups: Group[]) => {
    const bytes = groups.flatMap((one) => [...group(one), ...zeros(2 * (one.length ?? 1))]);
    return said(readPdu(direction, [0x15, bytes.length, ...bytes]));
  };

  test('the groups follow the rules of 0x14', () => {
    expect(write({})).toEqual([]);
    expect(write({ type: 5 })).toEqual(['error value-not-allowed']);
    expect(write({ file: 0 })).toEqual(['error value-out-of-range']);
    expect(write({ file: 11 })).toEqual(['note file-number-high']);
    expect(write({ record: 10000 })).toEqual(['error value-out-of-range']);
    expect(write({}, { record: 9999, length: 3 })).toEqual([]);
  });

  test('09 to FB bytes; above F5 the diagram of the section stops', () => {
    expect(write({ length: 119 })).toEqual([]);
    expect(write({ length: 122 })).toEqual(['note count-table-differs']);
    expect(write({ length: 123 })).toContain('error count-out-of-range');
    expect(write({ length: 0 })).toContain('error count-out-of-range');
  });

  test('a record length beyond the bytes leaves a rest', () => {
    const bytes = [...group({ length: 3 }), ...zeros(4)];
    expect(said(readPdu(direction, [0x15, bytes.length, ...bytes]))).toContain('error pdu-rest');
  });
});
