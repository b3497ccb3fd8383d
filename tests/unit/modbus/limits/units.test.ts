import { describe, expect, test } from 'vitest';
import { decodeFrame } from '../../../../src/modbus/index.ts';
import { said } from '../frames.ts';
import { asAscii, asRtu, asTcp } from '../reference.ts';

const READ = [0x03, 0, 0, 0, 1];

describe.each([
  ['rtu', asRtu],
  ['ascii', asAscii],
] as const)('units on a serial line, %s (SL 2.2)', (transport, wrap) => {
  const ask = (unit: number, pdu: readonly number[]) =>
    decodeFrame(wrap(unit, pdu), { transport, direction: 'request' });

  test('1 to 247 are single devices', () => {
    for (const unit of [1, 17, 246, 247]) expect(said(ask(unit, READ))).toEqual([]);
  });

  test('248 to 255 are reserved', () => {
    for (const unit of [248, 250, 255]) {
      expect(ask(unit, READ).problems).toMatchObject([
        { code: 'unit-reserved', severity: 'warning', got: unit, section: 'SL 2.2', span: { name: 'unitId' } },
      ]);
    }
  });

  test.each([
    [0x05, [0x05, 0, 0, 0xff, 0]],
    [0x06, [0x06, 0, 0, 0, 1]],
    [0x0f, [0x0f, 0, 0, 0, 1, 1, 1]],
    [0x10, [0x10, 0, 0, 0, 1, 2, 0, 1]],
  ])('%i may be broadcast (PI)', (_code, pdu) => {
    expect(said(ask(0, pdu))).toEqual([]);
  });

  test.each([
    [0x01, [0x01, 0, 0, 0, 1]],
    [0x02, [0x02, 0, 0, 0, 1]],
    [0x03, READ],
    [0x04, [0x04, 0, 0, 0, 1]],
    [0x07, [0x07]],
    [0x08, [0x08, 0, 0x0a, 0, 0]],
    [0x0b, [0x0b]],
    [0x0c, [0x0c]],
    [0x11, [0x11]],
    [0x14, [0x14, 7, 6, 0, 1, 0, 0, 0, 1]],
    [0x15, [0x15, 9, 6, 0, 1, 0, 0, 0, 1, 0, 0]],
    [0x16, [0x16, 0, 0, 0, 0, 0, 0]],
    [0x17, [0x17, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0, 0]],
    [0x18, [0x18, 0, 0]],
    [0x2b, [0x2b, 0x0e, 1, 0]],
  ])('nobody has agreed on a broadcast of %i', (functionCode, pdu) => {
    expect(ask(0, pdu).problems).toMatchObject([
      { code: 'broadcast-not-agreed', severity: 'warning', functionCode, section: 'SL 2.1', span: { name: 'unitId' } },
    ]);
  });

  test('a broadcast is not answered', () => {
    const reply = decodeFrame(wrap(0, [0x06, 0, 0, 0, 1]), { transport, direction: 'response' });
    expect(said(reply)).toEqual(['warning reply-from-broadcast']);
  });
});

describe('unit identifiers on TCP (TG 4.4.1.2)', () => {
  const ask = (unit: number) => said(decodeFrame(asTcp(unit, READ), { transport: 'tcp', direction: 'request' }));

  test('FF is the server itself, 1 to 247 a device behind it', () => {
    for (const unit of [0xff, 1, 247]) expect(ask(unit)).toEqual([]);
  });
  test('0 has two readings', () => {
    expect(ask(0)).toEqual(['note unit-zero-on-tcp']);
    const reply = decodeFrame(asTcp(0, [0x06, 0, 0, 0, 1]), { transport: 'tcp', direction: 'response' });
    expect(said(reply)).toEqual(['note unit-zero-on-tcp']);
  });
  test('248 to 254 have no rule', () => {
    for (const unit of [248, 250, 254]) expect(ask(unit)).toEqual(['note unit-unspecified']);
  });
});
