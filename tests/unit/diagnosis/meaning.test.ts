import { describe, expect, it } from 'vitest';
import type { FindingCode } from '../../../src/diagnosis/index.ts';
import { findingsOf, firstOf, type Known, repairsOf } from './findings.ts';

const rtu = { transport: 'rtu' } as const;
const tcp = { transport: 'tcp' } as const;
const FOUR = '01 03 00 00 00 04 44 09';
const TCP_REQUEST = '12 34 00 00 00 06 11 03 00 6B 00 03';

interface Example {
  readonly what: string;
  readonly bytes: string;
  readonly known?: Known;
  readonly found: { readonly code: FindingCode } & Record<string, unknown>;
  readonly repaired?: readonly string[];
}

const wrong: readonly Example[] = [
  {
    what: 'another unit answers',
    bytes: '17 06 40 03 00 17 2E F2',
    known: { ...rtu, request: '01 06 40 03 00 17 2C 04' },
    found: { code: 'unit-mismatch', got: 0x17, expected: 1, from: 0, to: 1 },
  },
  {
    what: 'a broadcast is answered',
    bytes: '01 06 00 01 00 03 98 0B',
    known: { ...rtu, request: '00 06 00 01 00 03 99 DA' },
    found: { code: 'broadcast-answered', from: 0, to: 1 },
  },
  {
    what: 'a reply to another function',
    bytes: '01 04 02 00 0A 39 37',
    known: { ...rtu, request: FOUR },
    found: { code: 'function-mismatch', got: 4, expected: 3 },
  },
  {
    what: 'a refusal of another function',
    bytes: '01 84 02 C2 C1',
    known: { ...rtu, request: FOUR },
    found: { code: 'exception-of-other-function', got: 4, expected: 3, exceptionCode: 2 },
  },
  {
    what: 'two registers where four were asked for',
    bytes: '01 03 04 00 0A 00 0B 9B F6',
    known: { ...rtu, request: FOUR },
    found: { code: 'quantity-in-32-bit', got: 4, expected: 8 },
  },
  {
    what: 'one register where four were asked for',
    bytes: '01 03 02 00 0A 38 43',
    known: { ...rtu, request: FOUR },
    found: { code: 'quantity-mismatch', got: 2, expected: 8 },
  },
  {
    what: 'a coil written as 1',
    bytes: '11 05 00 AC 00 01 CE BB',
    found: { code: 'coil-value-illegal', got: 1, from: 4, to: 6 },
    repaired: ['11 05 00 AC FF 00 4E 8B', '11 05 00 AC 00 00 0F 7B'],
  },
  {
    what: 'bits beyond the quantity',
    bytes: '01 0F 00 00 00 03 01 0F CF 53',
    found: { code: 'padding-bits', quantity: 3, got: 1, from: 7, to: 8 },
    repaired: ['01 0F 00 00 00 03 01 07 CE 95'],
  },
  {
    what: 'too many registers at once',
    bytes: '01 03 00 00 00 7E C5 EA',
    found: { code: 'rule-broken', problem: expect.objectContaining({ code: 'quantity-out-of-range', got: 126 }) },
  },
  {
    what: 'the address next to the one asked for',
    bytes: '01 10 00 02 00 02 E0 08',
    known: { ...rtu, request: '01 10 00 01 00 02 04 00 0A 01 02 92 30' },
    found: { code: 'address-off-by-one', got: 2, expected: 1 },
  },
  {
    what: 'a value repeated with its bytes swapped',
    bytes: '01 06 00 64 34 12 5E D8',
    known: { ...rtu, request: '01 06 00 64 12 34 C5 62' },
    found: { code: 'register-bytes-swapped', got: 0x3412, swapped: 0x1234 },
  },
  {
    what: 'a TCP frame on a serial line',
    bytes: TCP_REQUEST,
    known: rtu,
    found: { code: 'mbap-on-serial', transactionId: 0x1234 },
    repaired: ['11 03 00 6B 00 03 76 87'],
  },
  {
    what: 'an RTU frame on a TCP connection',
    bytes: '11 03 00 6B 00 03 76 87',
    known: tcp,
    found: { code: 'rtu-on-tcp' },
    repaired: ['00 00 00 00 00 06 11 03 00 6B 00 03'],
  },
  {
    what: 'an RTU frame where ASCII is spoken',
    bytes: '11 03 00 6B 00 03 76 87',
    known: { transport: 'ascii' },
    found: { code: 'rtu-on-ascii' },
  },
  {
    what: 'a CRC behind a TCP frame',
    bytes: `${TCP_REQUEST} 76 87`,
    known: tcp,
    found: { code: 'crc-on-tcp', from: 12, to: 14 },
    repaired: [TCP_REQUEST],
  },
  {
    what: 'a CRC that the length of a TCP frame counts',
    bytes: '12 34 00 00 00 08 11 03 00 6B 00 03 76 87',
    known: tcp,
    found: { code: 'crc-on-tcp' },
    repaired: [TCP_REQUEST],
  },
  {
    what: 'a transaction with its bytes swapped',
    bytes: '34 12 00 00 00 09 11 03 06 AE 41 56 52 43 40',
    known: { ...tcp, request: TCP_REQUEST },
    found: { code: 'transaction-swapped', got: 0x3412, expected: 0x1234, from: 0, to: 2 },
    repaired: ['12 34 00 00 00 09 11 03 06 AE 41 56 52 43 40'],
  },
  {
    what: 'another transaction',
    bytes: '12 33 00 00 00 09 11 03 06 AE 41 56 52 43 40',
    known: { ...tcp, request: TCP_REQUEST },
    found: { code: 'transaction-mismatch', got: 0x1233, expected: 0x1234 },
  },
];

it.each(wrong.map((example) => [example.what, example] as const))(
  '%s',
  (_, { bytes, known = rtu, found, repaired }) => {
    const first = firstOf(bytes, known);
    expect(first).toMatchObject({ ...found, confidence: 'certain' });
    if (repaired) expect(repairsOf(first)).toEqual(repaired);
  },
);

describe('nothing is wrong', () => {
  it.each<[string, string, Known, object]>([
    ['an RTU request', FOUR, {}, { code: 'valid', transport: 'rtu', directions: ['request'], functionCode: 3 }],
    ['a TCP request', TCP_REQUEST, {}, { code: 'valid', transport: 'tcp', directions: ['request'] }],
    ['an ASCII request', ':1103006B00037E\r\n', {}, { code: 'valid', transport: 'ascii', directions: ['request'] }],
    ['a bare PDU', '03 00 6B 00 03', {}, { code: 'valid', transport: 'pdu', directions: ['request'] }],
    ['a refusal', '01 83 02 C0 F1', {}, { code: 'valid-exception', functionCode: 3, exceptionCode: 2 }],
    [
      'an RTU reply to a request in TCP',
      '11 03 06 AE 41 56 52 43 40 49 AD',
      { request: TCP_REQUEST },
      { code: 'valid' },
    ],
    ['registers that hold a float', '42 F6 E9 79', {}, { code: 'valid-data', registers: 2, plausible: 'float' }],
    [
      'registers that hold small numbers',
      '00 07 01 F4',
      {},
      { code: 'valid-data', registers: 2, plausible: 'integer' },
    ],
  ])('%s', (_, bytes, known, expected) => {
    expect(firstOf(bytes, known)).toMatchObject(expected);
  });
});

describe('hints', () => {
  const hint = (code: FindingCode, bytes: string, known: Known = {}) =>
    findingsOf(bytes, known).find((one) => one.code === code);

  it('40001 was sent as an address', () => {
    const found = hint('address-is-number', '01 03 9C 41 00 01 FA 4E');
    expect(found).toMatchObject({ number: 40001, address: 0, confidence: 'possible' });
    expect(repairsOf(found!)).toEqual(['01 03 00 00 00 01 84 0A']);
  });

  it('30001 is of the table that 04 reads', () => {
    const found = hint('function-of-other-table', '01 03 75 31 00 01 CF C9');
    expect(found).toMatchObject({ functionCode: 3, meant: 4, number: 30001, confidence: 'possible' });
    expect(repairsOf(found!)).toEqual(['01 04 00 00 00 01 31 CA']);
  });

  it('a refused address may be off by one, or of another table', () => {
    const known = { request: '11 03 00 6B 00 03 76 87' };
    const refusal = '11 83 02 C1 34';
    const next = hint('address-off-by-one', refusal, known);
    expect(next).toMatchObject({ got: 0x6b, expected: 0x6a });
    expect(repairsOf(next!)).toEqual(['11 03 00 6A 00 03 27 47']);
    expect(hint('function-of-other-table', refusal, known)).toMatchObject({ meant: 4, number: undefined });
  });

  it('registers with the low byte first', () => {
    const found = hint('register-bytes-swapped', '05 03 02 F4 01 CE 84');
    expect(found).toMatchObject({ got: 0xf401, swapped: 500, from: 3, to: 5, confidence: 'possible' });
  });

  it('pairs of registers that are 32-bit numbers', () => {
    const bytes = '01 03 10 11 02 FF F8 04 42 FF FE 2E 32 00 0A 2E 32 00 0A F8 D5';
    expect(hint('quantity-in-32-bit', bytes)).toMatchObject({ got: 16, expected: 32, confidence: 'possible' });
  });

  it('stand below what is proved, and are not made of common values', () => {
    expect(findingsOf(FOUR).map(({ code }) => code)).toEqual(['valid']);
    expect(findingsOf('01 03 9C 41 00 01 FA 4E').map(({ code }) => code)[0]).toBe('valid');
  });
});
