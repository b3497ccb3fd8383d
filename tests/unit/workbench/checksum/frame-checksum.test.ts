import { describe, expect, it } from 'vitest';
import { decodeFrame, fromHex } from '../../../../src/modbus/index.ts';
import { frameChecksum } from '../../../../src/workbench/checksum/frame-checksum.ts';

const ascii = (text: string) => Uint8Array.from(text, (character) => character.charCodeAt(0));
const of = (bytes: Uint8Array, transport: 'rtu' | 'ascii' | 'tcp' | 'pdu') =>
  frameChecksum(decodeFrame(bytes, { transport, direction: 'request' }), bytes);
const rtu = (hex: string) => of(fromHex(hex)!, 'rtu');

describe('how the checksum of a frame comes about', () => {
  it('is told by the register after each byte, which is sent low byte first', () => {
    // SL 6.2.2: the CRC of 02 07 is 0x1241, which goes out as 41 12. After 02 the register is 0x813E.
    expect(rtu('02074112')).toEqual({
      kind: 'crc',
      covered: Uint8Array.of(0x02, 0x07),
      initial: 0xffff,
      last: [
        { at: 0, value: 0x02, register: 0x813e },
        { at: 1, value: 0x07, register: 0x1241 },
      ],
      register: 0x1241,
      sent: Uint8Array.of(0x41, 0x12),
      got: Uint8Array.of(0x41, 0x12),
    });
  });

  it('says what the frame has instead', () => {
    // The drive's guide prints E6 A1 for 06 06 02 AB 10 00; the CRC is 0xE5F5.
    expect(rtu('060602AB1000E6A1')).toMatchObject({
      register: 0xe5f5,
      sent: Uint8Array.of(0xf5, 0xe5),
      got: Uint8Array.of(0xe6, 0xa1),
    });
  });

  it('tells no more than the last eight registers', () => {
    const long = rtu('011000000008100000000000000000000000000000000035AF');
    expect(long).toMatchObject({ kind: 'crc', register: expect.any(Number) });
    expect(long.kind === 'crc' && long.last.map(({ at }) => at)).toEqual([15, 16, 17, 18, 19, 20, 21, 22]);
  });

  it('covers all that there is of a frame that ends before its CRC', () => {
    expect(rtu('0207')).toMatchObject({ kind: 'crc', covered: Uint8Array.of(0x02, 0x07), register: 0x1241 });
  });

  it('is the LRC of the bytes that the characters of ASCII carry', () => {
    // 06 + 06 + 02 + AB + 10 + 00 = C9, whose two's complement is 37.
    expect(of(ascii(':060602AB100037\r\n'), 'ascii')).toEqual({
      kind: 'lrc',
      covered: fromHex('060602AB1000'),
      sum: 0xc9,
      lrc: 0x37,
      got: ascii('37'),
    });
    expect(of(ascii(':06x602AB100037\r\n'), 'ascii')).toEqual({ kind: 'none', why: 'not-digits' });
  });

  it('is not there in TCP and in a bare PDU', () => {
    expect(of(fromHex('000100000006010300000001')!, 'tcp')).toEqual({ kind: 'none', why: 'tcp' });
    expect(of(fromHex('0300000001')!, 'pdu')).toEqual({ kind: 'none', why: 'pdu' });
  });
});
