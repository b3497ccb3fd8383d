import { describe, expect, test } from 'vitest';
import { decodeFrame, type Reading } from '../../../src/modbus/index.ts';
import { encodedAgain, hex, readPdu, said, saidWhere } from './frames.ts';
import { asAscii, asRtu, asTcp } from './reference.ts';

const reply = (request: string, response: string): Reading => {
  const [asked, answered] = [Array.from(hex(request)), Array.from(hex(response))];
  const reading = readPdu('response', answered, asked);
  expect(encodedAgain(reading)).toBe(Buffer.from(answered).toString('hex').toUpperCase());
  return reading;
};

describe('bits: only the request tells how many there are', () => {
  test.each([1, 2])('as many as function code %i asked', (code) => {
    const [asked, answered] = [`0${code} 0013 000A`, `0${code} 02 CD01`];
    expect(reply(asked, answered).fields['bits']).toEqual([1, 0, 1, 1, 0, 0, 1, 1, 1, 0]);
    expect(readPdu('response', Array.from(hex(answered))).fields['bits']).toHaveLength(16);
  });
  test('all of them, where the byte count is not what was asked', () => {
    const reading = reply('01 0013 0005', '01 02 CD01');
    expect(saidWhere(reading)).toEqual(['error count-not-as-requested 1-2']);
    expect(reading.problems[0]).toMatchObject({ got: 2, expected: 1 });
    expect(reading.fields['bits']).toHaveLength(16);
  });
});

describe('the byte count is what was asked', () => {
  test.each([
    ['03 006B 0003', '03 06 0000 0000 0000', '03 04 0000 0000'],
    ['04 0008 0001', '04 02 0000', '04 04 0000 0000'],
    ['17 0003 0002 000E 0001 02 00FF', '17 04 0000 0000', '17 02 0000'],
    ['02 00C4 0016', '02 03 000000', '02 02 0000'],
  ])('%s', (asked, right, wrong) => {
    expect(said(reply(asked, right))).toEqual([]);
    expect(said(reply(asked, wrong))).toEqual(['error count-not-as-requested']);
  });
});

describe('a write is echoed', () => {
  test.each([
    ['05 00AC FF00', '05 00AD FF00', 'address'],
    ['05 00AC FF00', '05 00AC 0000', 'value'],
    ['06 0001 0003', '06 0002 0003', 'address'],
    ['06 0001 0003', '06 0001 0004', 'value'],
    ['0F 0013 000A 02 CD01', '0F 0014 000A', 'startAddress'],
    ['0F 0013 000A 02 CD01', '0F 0013 000B', 'quantity'],
    ['10 0001 0001 02 000A', '10 0000 0001', 'startAddress'],
    ['10 0001 0001 02 000A', '10 0001 0002', 'quantity'],
    ['16 0004 00F2 0025', '16 0005 00F2 0025', 'referenceAddress'],
    ['16 0004 00F2 0025', '16 0004 00F3 0025', 'andMask'],
    ['16 0004 00F2 0025', '16 0004 00F2 0024', 'orMask'],
    ['15 09 06 0004 0007 0001 06AF', '15 09 06 0004 0007 0001 06AE', 'subRequests'],
    ['08 0000 A537', '08 0000 A538', 'data'],
    ['08 0003 3B00', '08 0003 0A00', 'data'],
    ['08 000A 0000', '08 000A 0001', 'data'],
    ['08 000B 0000', '08 000C 0000', 'subFunction'],
    ['2B 0E 01 00', '2B 0D 01 00', 'meiType'],
  ])('%s, not %s', (asked, answered, field) => {
    expect(reply(asked, answered).problems).toContainEqual(
      expect.objectContaining({ code: 'echo-differs', severity: 'error', field }),
    );
  });

  test.each([
    ['05 00AC FF00', '05 00AC FF00'],
    ['06 0001 0003', '06 0001 0003'],
    ['0F 0013 000A 02 CD01', '0F 0013 000A'],
    ['10 0001 0001 02 000A', '10 0001 0001'],
    ['16 0004 00F2 0025', '16 0004 00F2 0025'],
    ['15 09 06 0004 0007 0001 06AF', '15 09 06 0004 0007 0001 06AF'],
    ['08 0000 A537', '08 0000 A537'],
    ['08 000B 0000', '08 000B 1234'],
  ])('%s by %s', (asked, answered) => {
    expect(said(reply(asked, answered))).toEqual([]);
  });
});

describe('a reply comes from the unit that was asked, for the function that was asked', () => {
  const ASKED = [0x03, 0, 0, 0, 1];
  const ANSWERED = [0x03, 2, 0, 7];

  test.each([
    ['rtu', asRtu],
    ['ascii', asAscii],
    ['tcp', asTcp],
  ] as const)('%s', (transport, wrap) => {
    const answer = (unit: number, pdu: readonly number[], from = 0x11) =>
      decodeFrame(wrap(unit, pdu), { transport, direction: 'response', request: wrap(from, ASKED) });
    expect(said(answer(0x11, ANSWERED))).toEqual([]);
    expect(answer(0x12, ANSWERED).problems).toMatchObject([
      { code: 'unit-not-as-requested', severity: 'error', got: 0x12, expected: 0x11, span: { name: 'unitId' } },
    ]);
    expect(answer(0x11, [0x04, 2, 0, 7]).problems).toMatchObject([
      { code: 'function-not-as-requested', severity: 'error', got: 4, expected: 3, span: { name: 'functionCode' } },
    ]);
    expect(said(answer(0x11, [0x83, 2]))).toEqual([]);
    expect(said(answer(0x11, [0x84, 2]))).toEqual(['error function-not-as-requested']);
  });

  test('and on TCP for the transaction that was opened', () => {
    const request = asTcp(1, ASKED, 7);
    const answer = (transaction: number) =>
      decodeFrame(asTcp(1, ANSWERED, transaction), { transport: 'tcp', direction: 'response', request });
    expect(said(answer(7))).toEqual([]);
    expect(answer(8).problems).toMatchObject([
      { code: 'transaction-not-as-requested', severity: 'error', got: 8, expected: 7, section: 'TG 3.1.3' },
    ]);
  });
});

test('a broadcast is not answered, by whichever unit (SL 2.1)', () => {
  const pdu = [0x06, 0, 1, 0, 3];
  for (const unit of [0, 1]) {
    const reading = decodeFrame(asRtu(unit, pdu), {
      transport: 'rtu',
      direction: 'response',
      request: asRtu(0, pdu),
    });
    expect(said(reading)).toContain('error broadcast-answered');
  }
  // On TCP unit 0 is no broadcast (TG 4.4.1.2).
  const onTcp = decodeFrame(asTcp(0, pdu), { transport: 'tcp', direction: 'response', request: asTcp(0, pdu) });
  expect(said(onTcp)).toEqual(['note unit-zero-on-tcp']);
});

test('a request that is no frame is no measure, and neither is one beside a request', () => {
  const answered = [0x03, 4, 0, 7, 0, 8];
  expect(said(readPdu('response', answered, []))).toEqual([]);
  expect(said(readPdu('response', answered, [0x03]))).toEqual([]);
  expect(said(readPdu('response', answered, [0x03, 0, 0, 0]))).toEqual([]);
  expect(said(readPdu('request', [0x03, 0, 0, 0, 1], [0x04, 0, 0, 0, 2]))).toEqual([]);
});
