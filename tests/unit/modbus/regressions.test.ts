import { describe, expect, test } from 'vitest';
import { decodeFrame, encodeFrame, FrameError, type FrameInput } from '../../../src/modbus/index.ts';
import { readBits } from '../../../src/notation/index.ts';
import { characters, hex, readPdu, said } from './frames.ts';

describe('a frame that is not there yet is not called wrong', () => {
  const ask = (text: string) => decodeFrame(characters(text), { transport: 'ascii', direction: 'request' });

  test('ASCII, one digit of a pair there: one digit less is missing, and no odd digit is a fault yet', () => {
    // 17 characters in all.
    const reading = ask(':1103006B00037');
    expect(reading.outcome).toEqual({ kind: 'short', missing: 3 });
    expect(said(reading)).toEqual(['error frame-short']);
    expect(ask(':1103006').outcome).toEqual({ kind: 'short', missing: 9 });
    expect(ask(':1').outcome).toEqual({ kind: 'short', missing: 7 });
  });

  test('ASCII, a function of open length without CR LF: its last byte is no LRC yet', () => {
    expect(said(ask(':112B0D0001'))).toEqual(['error frame-short']);
    expect(said(ask(':110800001234'))).toEqual(['error frame-short']);
  });

  test('ASCII, an LRC that holds by chance inside a frame without CR LF', () => {
    // 11 03 06 00 00 | E6: the LRC of what is there so far; four registers' bytes are still to come.
    const reading = decodeFrame(characters(':1103060000E6'), { transport: 'ascii', direction: 'response' });
    expect(reading.outcome).toEqual({ kind: 'short', missing: 10 });
    expect(said(reading)).toEqual(['error frame-short']);
  });

  test('RTU and TCP, one of two bytes of diagnostic data there', () => {
    const rtu = decodeFrame(hex('11 08 0002 00'), { transport: 'rtu', direction: 'request' });
    expect(rtu.outcome).toEqual({ kind: 'short', missing: 3 });
    expect(said(rtu)).toEqual(['error frame-short']);
    const tcp = decodeFrame(hex('0001 0000 0006 11 08 0000 A5'), { transport: 'tcp', direction: 'request' });
    expect(tcp.outcome).toEqual({ kind: 'short', missing: 1 });
    expect(said(tcp).filter((what) => what.startsWith('error'))).toEqual(['error frame-short']);
  });
});

describe('what is missing is exact once a byte count is there', () => {
  test.each([
    [0x18, '11 18 0006 0002 01B8 1284 188D', [4, 3, 6, 5, 8, 7, 6, 5, 4, 3, 2, 1]],
    [0x0c, '11 0C 08 0000 0108 0121 2000 5901', [4, 3, 9, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1]],
  ])('%i', (_code, text, missing) => {
    const bytes = hex(text);
    const found = missing.map((_, there) => {
      const { outcome } = decodeFrame(bytes.subarray(0, there), { transport: 'rtu', direction: 'response' });
      return outcome.kind === 'short' ? outcome.missing : outcome.kind;
    });
    expect(found).toEqual(missing);
  });
});

describe('what has no bytes is refused with the field that a person typed', () => {
  const refusal = (functionCode: number, fields: Record<string, unknown>, more: Partial<FrameInput> = {}) => {
    try {
      encodeFrame({ transport: 'pdu', direction: 'request', functionCode, fields, ...more });
    } catch (error) {
      return error instanceof FrameError ? `${error.field}: ${error.code}` : `${error}`;
    }
    return 'it has bytes';
  };
  const response = { direction: 'response' } as const;

  test('a group that is nothing', () => {
    expect(refusal(0x15, { subRequests: [null] })).toMatch(/^subRequests\[0\]: /);
    expect(refusal(0x15, { subRequests: [undefined] })).toMatch(/^subRequests\[0\]: /);
    expect(refusal(0x14, { subResponses: [null] }, response)).toMatch(/^subResponses\[0\]: /);
  });

  test('a list that is missing or none, not the count derived from it', () => {
    expect(refusal(0x10, { startAddress: 0 })).toBe('registers: field-missing');
    expect(refusal(0x10, { startAddress: 0, registers: 'abc' })).toBe('registers: not-a-list');
    expect(refusal(0x10, { startAddress: 0, registers: null })).toBe('registers: not-a-list');
    expect(refusal(0x0f, { startAddress: 0 })).toBe('bits: field-missing');
    expect(refusal(0x03, {}, response)).toBe('registers: field-missing');
    expect(refusal(0x14, {})).toBe('subRequests: field-missing');
    expect(refusal(0x15, { subRequests: 7 })).toBe('subRequests: not-a-list');
    const group = { referenceType: 6, fileNumber: 1, recordNumber: 0 };
    expect(refusal(0x15, { subRequests: [group] })).toBe('subRequests[0].recordData: field-missing');
  });

  test('hexadecimal pairs with an odd digit, not the count derived from them', () => {
    expect(refusal(0x11, { data: 'ABC' }, response)).toBe('data: not-hex');
    expect(refusal(0x11, {}, response)).toBe('data: field-missing');
  });

  test('a forced part that is bytes only, forced to a number', () => {
    const read = { startAddress: 0, quantity: 1 };
    expect(refusal(0x03, read, { force: { after: 5 } })).toBe('after: not-hex');
    for (const part of ['start', 'characters', 'end']) {
      const ascii = { transport: 'ascii', unitId: 1, force: { [part]: 5 } } as const;
      expect(refusal(0x03, read, ascii)).toBe(`${part}: not-hex`);
    }
  });
});

test('a coil is echoed byte by byte, illegal values too (AP 6.5)', () => {
  const reply = readPdu('response', Array.from(hex('05 00AC FF00')), Array.from(hex('05 00AC 0001')));
  expect(said(reply)).toEqual(['error echo-differs']);
});

test('the FIFO count that a byte count makes is a whole number (AP 6.18)', () => {
  const { problems } = readPdu('response', Array.from(hex('18 0003 0001 00')));
  for (const problem of problems) {
    if ('expected' in problem) expect(problem.expected).toSatisfy((n: number) => Number.isInteger(n) && n >= 0);
  }
});

test('a missing colon is said of a span of the reading', () => {
  const reading = decodeFrame(characters('\r\n'), { transport: 'ascii', direction: 'request' });
  for (const { code, span } of reading.problems) expect(span.to, code).toBeGreaterThan(span.from);
});

test.each(['constructor', 'toString', '__proto__', 'valueOf'])(
  '%s, a name that every object has, is not a bit',
  (text) => {
    expect(readBits(text)).toMatchObject({ kind: 'wrong', index: 0 });
  },
);
