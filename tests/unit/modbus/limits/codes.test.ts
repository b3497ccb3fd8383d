import { describe, expect, test } from 'vitest';
import { decodeFrame } from '../../../../src/modbus/index.ts';
import { readPdu, said } from '../frames.ts';
import { asRtu, asTcp } from '../reference.ts';

describe('function codes without a layout', () => {
  const ask = (code: number) => said(readPdu('request', [code, 1, 2, 3]));
  const range = (from: number, to: number) => Array.from({ length: to - from + 1 }, (_, i) => from + i);

  test('0 is no function code (AP 4.1)', () => {
    expect(ask(0)).toEqual(['error function-zero']);
    expect(said(readPdu('response', [0x80, 1]))).toEqual(['error function-zero']);
  });

  test('65 to 72 and 100 to 110 are the users’ (AP 5)', () => {
    for (const code of [...range(65, 72), ...range(100, 110)]) {
      expect(ask(code)).toEqual(['note function-user-defined']);
    }
  });

  test.each([9, 10, 13, 14, 41, 42, 90, 91, 125, 126, 127])('%i is reserved (AP Annex A)', (code) => {
    expect(ask(code)).toEqual(['warning function-reserved']);
    expect(readPdu('request', [code]).problems[0]).toMatchObject({ got: code, section: 'AP Annex A' });
  });

  test.each([18, 19, 25, 40, 44, 64, 73, 99, 111, 124])('%i has no meaning', (code) => {
    expect(ask(code)).toEqual(['warning function-unassigned']);
  });

  test('from 128 on they are for exceptions, never for a request (AP 4.1)', () => {
    for (const code of [0x80, 0x83, 0xff]) expect(ask(code)).toEqual(['error function-above-127']);
  });

  test('the company that is known to use a code is named', () => {
    expect(readPdu('request', [90]).problems).toMatchObject([{ vendor: 'UMAS (Schneider Electric)' }]);
    expect(readPdu('request', [70]).problems).toMatchObject([{ vendor: 'Fast Modbus (Wiren Board)' }]);
    expect(readPdu('request', [65]).problems).toMatchObject([{ vendor: undefined }]);
  });

  test('an exception says the same of the code it answers', () => {
    expect(said(readPdu('response', [0x80 + 65, 1]))).toEqual(['note function-user-defined']);
    expect(said(readPdu('response', [0x80 + 90, 1]))).toEqual(['warning function-reserved']);
    expect(said(readPdu('response', [0x80 + 25, 1]))).toEqual(['warning function-unassigned']);
  });
});

describe('exception codes (AP 7)', () => {
  const refused = (code: number) => said(readPdu('response', [0x83, code]));

  test('01 to 06, 08, 0A and 0B are defined', () => {
    for (const code of [1, 2, 3, 4, 5, 6, 8, 0x0a, 0x0b]) expect(refused(code)).toEqual([]);
  });
  test('07 stands in PI only', () => {
    expect(refused(7)).toEqual(['note exception-pi-only']);
    expect(readPdu('response', [0x8d, 7]).problems.at(-1)).toMatchObject({ section: 'PI App. A' });
  });
  test.each([0, 9, 0x0c, 0x7f, 0xff])('%i is not defined', (code) => {
    expect(refused(code)).toEqual(['warning exception-undefined']);
  });
  test('an exception has one byte behind its function code', () => {
    expect(readPdu('response', [0x83]).outcome).toEqual({ kind: 'short', missing: 1 });
    expect(readPdu('response', [0x83, 2, 0]).outcome).toEqual({ kind: 'extra', bytes: 1 });
  });
});

test.each([
  { code: 0x07, pdu: [0x07] },
  { code: 0x08, pdu: [0x08, 0x00, 0x02, 0x00, 0x00] },
  { code: 0x0b, pdu: [0x0b] },
  { code: 0x0c, pdu: [0x0c] },
  { code: 0x11, pdu: [0x11] },
])('$code is for the serial line only: a note on TCP (AP 6)', ({ code, pdu }) => {
  const onTcp = decodeFrame(asTcp(1, pdu), { transport: 'tcp', direction: 'request' });
  expect(onTcp.problems).toMatchObject([
    { code: 'function-serial-only', severity: 'note', functionCode: code, span: { from: 7, to: 8 } },
  ]);
  expect(said(decodeFrame(asRtu(1, pdu), { transport: 'rtu', direction: 'request' }))).toEqual([]);
});
