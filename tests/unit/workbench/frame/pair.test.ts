import { describe, expect, it } from 'vitest';
import { fromHex } from '../../../../src/modbus/index.ts';
import { type Draft, firstDraft } from '../../../../src/workbench/frame/draft.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { pairOf, parted, replyOfPair, replyTo, requestOfPair } from '../../../../src/workbench/frame/pair.ts';

const hex = (text: string) => fromHex(text.replaceAll(' ', ''))!;
const draftOf = (transport: Draft['transport'], texts: Draft['texts']): Draft => ({ ...firstDraft, transport, texts });
const framed = (draft: Draft) => ({ draft, bytes: evaluate(draft).frame!.bytes });
const pair = (draft: Draft) => pairOf(draft, evaluate(draft).frame);

/** AP 6.3: registers 108 to 110 of unit 17. */
const READ = draftOf('rtu', { unitId: '17', functionCode: '3', startAddress: 'HR108', quantity: '3' });
const READ_REPLY = hex('11 03 06 02 2B 00 00 00 64 C8 BA');

describe('a reply is joined to a request', () => {
  it.each([
    ['when unit, function and length agree', READ, '11 03 06 02 2B 00 00 00 64 C8 BA', 'unit-function-length'],
    ['as an exception, by its function', READ, '11 83 02 C1 34', 'exception'],
    [
      'as the echo of 05, by its content',
      draftOf('rtu', { unitId: '17', functionCode: '5', address: '172', value: '1' }),
      '11 05 00 AC FF 00 4E 8B',
      'same-content',
    ],
    [
      'as the echo of 06, by its content',
      draftOf('rtu', { unitId: '17', functionCode: '6', address: '1', value: '3' }),
      '11 06 00 01 00 03 9A 9B',
      'same-content',
    ],
    [
      'as the reply to 0F, by its content',
      draftOf('rtu', { unitId: '17', functionCode: '15', startAddress: '19', bits: '1 0 1 1 0 0 1 1 1 0' }),
      '11 0F 00 13 00 0A 26 99',
      'same-content',
    ],
    [
      'as the reply to 10, by its content',
      draftOf('rtu', { unitId: '17', functionCode: '16', startAddress: '1', registers: '10 258' }),
      '11 10 00 01 00 02 12 98',
      'same-content',
    ],
    [
      'on TCP when the transaction agrees too',
      draftOf('tcp', { transactionId: '0x1501', unitId: '255', functionCode: '3', startAddress: '4', quantity: '1' }),
      '15 01 00 00 00 05 FF 03 02 00 05',
      'transaction',
    ],
  ])('%s', (_what, request, reply, why) => {
    const joined = replyTo(framed(request), hex(reply))!;
    expect(evaluate(joined).frame?.bytes).toEqual(hex(reply));
    expect(pair(joined)).toMatchObject({ why, request: { draft: request } });
  });

  it.each([
    ['the unit differs', READ, '12 03 06 02 2B 00 00 00 64 8C BA'],
    ['the function differs', READ, '11 04 06 02 2B 00 00 00 64 E1 7A'],
    ['the length differs', READ, '11 03 04 02 2B 00 00 6B A9'],
    ['the exception is of another function', READ, '11 84 02 C3 04'],
    [
      'the content differs',
      draftOf('rtu', { unitId: '17', functionCode: '6', address: '1', value: '3' }),
      '11 06 00 01 00 04 DB 59',
    ],
    [
      'the transaction differs',
      draftOf('tcp', { transactionId: '0x1502', unitId: '255', functionCode: '3', startAddress: '4', quantity: '1' }),
      '15 01 00 00 00 05 FF 03 02 00 05',
    ],
  ])('but not if %s', (_what, request, reply) => {
    expect(replyTo(framed(request), hex(reply))).toBeUndefined();
  });
});

describe('a pair', () => {
  const typed: Draft = { ...READ, typed: { startAddress: { typed: '40108', text: 'HR108' } } };
  const reply = replyTo(framed(typed), READ_REPLY)!;

  it('brings the request back as it was typed, and the reply again', () => {
    const request = requestOfPair(pair(reply)!);
    expect(request).toMatchObject(typed);
    const again = pair(request)!;
    expect(again.reply.bytes).toEqual(READ_REPLY);
    expect(replyOfPair(again)).toEqual(reply);
  });

  it('has the request by its bytes where it was not typed here', () => {
    const { partner: _typed, ...plain } = reply;
    expect(pair(plain)?.request.draft.texts).toEqual({
      unitId: '17',
      functionCode: '3',
      startAddress: '0x006B',
      quantity: '3',
    });
  });

  it('is none once it is parted, or the request asks for something else', () => {
    expect(pair(parted(reply))).toBeUndefined();
    const request = requestOfPair(pair(reply)!);
    expect(pair({ ...request, texts: { ...request.texts, quantity: '4' } })).toBeUndefined();
    expect(pair({ ...request, texts: { ...request.texts, quantity: '3' } })).toBeDefined();
  });

  it('says that a reply does not answer the request that it is said to answer', () => {
    expect(pair({ ...parted(reply), answering: '11 03 00 6B 00 04 37 45' })?.why).toBe('differs');
  });
});
