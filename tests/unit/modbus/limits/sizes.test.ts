import { describe, expect, test } from 'vitest';
import { decodeFrame, type Transport } from '../../../../src/modbus/index.ts';
import { said, zeros } from '../frames.ts';
import { asAscii, asRtu, asTcp } from '../reference.ts';

/** A PDU of so many bytes; the code is a user's, so nothing but its size can be wrong. */
const pdu = (size: number) => [0x41, ...zeros(size - 1)];
const read = (bytes: Uint8Array, transport: Transport) => decodeFrame(bytes, { transport, direction: 'request' });
const CLEAN = ['note function-user-defined'];

describe('a PDU has at most 253 bytes (AP 4.1)', () => {
  test('bare', () => {
    expect(said(read(Uint8Array.from(pdu(253)), 'pdu'))).toEqual(CLEAN);
    expect(read(Uint8Array.from(pdu(254)), 'pdu').problems[1]).toMatchObject({
      code: 'pdu-too-long',
      severity: 'error',
      got: 254,
      most: 253,
      section: 'AP 4.1',
    });
  });
  test('so an RTU frame has 256 (SL 2.5.1)', () => {
    expect(asRtu(1, pdu(253))).toHaveLength(256);
    expect(said(read(asRtu(1, pdu(253)), 'rtu'))).toEqual(CLEAN);
    expect(said(read(asRtu(1, pdu(254)), 'rtu'))).toEqual([...CLEAN, 'error pdu-too-long']);
  });
  test('an ASCII frame 513 characters (SL 2.5.2.1)', () => {
    expect(asAscii(1, pdu(253))).toHaveLength(513);
    expect(said(read(asAscii(1, pdu(253)), 'ascii'))).toEqual(CLEAN);
    expect(said(read(asAscii(1, pdu(254)), 'ascii'))).toEqual([...CLEAN, 'error pdu-too-long']);
  });
  test('and a TCP frame 260, with 254 in its length field (TG 3.1.3)', () => {
    expect(asTcp(1, pdu(253))).toHaveLength(260);
    expect(said(read(asTcp(1, pdu(253)), 'tcp'))).toEqual(CLEAN);
    expect(said(read(asTcp(1, pdu(254)), 'tcp'))).toEqual([
      ...CLEAN,
      'error pdu-too-long',
      'error mbap-length-out-of-range',
    ]);
  });
});

test('the length field of TCP is at least 2: a unit and a function code (TG 3.1.3)', () => {
  expect(said(read(asTcp(1, [0x41]), 'tcp'))).toEqual(CLEAN);
  for (const length of [0, 1]) {
    const bytes = Uint8Array.of(0, 1, 0, 0, 0, length, 1, 0x41);
    expect(said(read(bytes, 'tcp'))).toContain('error mbap-length-out-of-range');
  }
});

test('the protocol identifier is 0 (TG 3.1.3)', () => {
  const bytes = asTcp(1, [0x41]);
  bytes[3] = 1;
  const reading = read(bytes, 'tcp');
  expect(reading.problems).toMatchObject([
    { code: 'protocol-id-not-zero', severity: 'error', got: 1, span: { from: 2, to: 4 } },
    { code: 'function-user-defined' },
  ]);
  expect(reading.forced).toEqual({ protocolId: 1 });
});
