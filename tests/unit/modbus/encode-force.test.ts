import { describe, expect, test } from 'vitest';
import { encodeFrame, FrameError, type FrameInput, toHex } from '../../../src/modbus/index.ts';
import { characters, hex } from './frames.ts';

const write = {
  direction: 'request',
  unitId: 0x11,
  functionCode: 0x10,
  fields: { startAddress: 1, registers: [10, 258] },
} as const;
const read = {
  direction: 'request',
  unitId: 0x11,
  functionCode: 0x03,
  fields: { startAddress: 107, quantity: 3 },
} as const;

const bytesOf = (input: FrameInput) => toHex(encodeFrame(input));
const same = (text: string) => toHex(hex(text));

describe('a PDU with something forced', () => {
  const forced = (force: FrameInput['force'], input: Pick<FrameInput, 'functionCode' | 'fields'> = write) =>
    bytesOf({ direction: 'request', ...input, transport: 'pdu', force });

  test('nothing', () => {
    expect(forced({})).toBe(same('10 0001 0002 04 000A 0102'));
  });
  test('counts', () => {
    expect(forced({ byteCount: 5 })).toBe(same('10 0001 0002 05 000A 0102'));
    expect(forced({ quantity: 200 })).toBe(same('10 0001 00C8 04 000A 0102'));
    expect(forced({ quantity: 0, byteCount: 255 })).toBe(same('10 0001 0000 FF 000A 0102'));
  });
  test('a field that is typed', () => {
    expect(forced({ startAddress: 2 })).toBe(same('10 0002 0002 04 000A 0102'));
  });
  test('bytes verbatim, and none', () => {
    expect(forced({ quantity: 'AB' })).toBe(same('10 0001 AB 04 000A 0102'));
    expect(forced({ byteCount: '', registers: '00' })).toBe(same('10 0001 0002 00'));
    expect(forced({ functionCode: '' })).toBe(same('0001 0002 04 000A 0102'));
  });
  test('bytes behind the fields', () => {
    expect(forced({ rest: 'DE AD' })).toBe(same('10 0001 0002 04 000A 0102 DEAD'));
    expect(forced({ rest: '01', after: '02' })).toBe(same('10 0001 0002 04 000A 0102 01 02'));
  });
  test('the unused bits of a bit field', () => {
    const coils = { functionCode: 0x0f, fields: { startAddress: 0, bits: [1, 0, 1] } };
    expect(forced({}, coils)).toBe(same('0F 0000 0003 01 05'));
    expect(forced({ padding: 1 }, coils)).toBe(same('0F 0000 0003 01 0D'));
    expect(forced({ padding: 31 }, coils)).toBe(same('0F 0000 0003 01 FD'));
    expect(() => forced({ padding: 32 }, coils)).toThrow(FrameError);
    // Eight bits leave none unused.
    const eight = { functionCode: 0x0f, fields: { startAddress: 0, bits: [1, 0, 1, 0, 0, 0, 0, 0] } };
    expect(forced({ padding: 1 }, eight)).toBe(same('0F 0000 0008 01 05'));
  });
  test('the raw value of a coil', () => {
    const coil = { functionCode: 0x05, fields: { address: 172, value: true } };
    expect(forced({}, coil)).toBe(same('05 00AC FF00'));
    expect(forced({ rawValue: 1 }, coil)).toBe(same('05 00AC 0001'));
    expect(() => forced({ rawValue: 65536 }, coil)).toThrow(FrameError);
  });
});

describe('an RTU frame with something forced', () => {
  const forced = (force: FrameInput['force']) => bytesOf({ ...read, transport: 'rtu', force });

  test('its CRC, as the register or as bytes', () => {
    expect(forced({})).toBe(same('11 03 006B 0003 7687'));
    expect(forced({ checksum: 0x7687 })).toBe(same('11 03 006B 0003 8776'));
    expect(forced({ checksum: '1234' })).toBe(same('11 03 006B 0003 1234'));
    expect(forced({ checksum: '76' })).toBe(same('11 03 006B 0003 76'));
    expect(forced({ checksum: '' })).toBe(same('11 03 006B 0003'));
    expect(() => forced({ checksum: 65536 })).toThrow(FrameError);
    expect(() => forced({ checksum: 'no' })).toThrow(FrameError);
  });
  test('what has no bytes is named', () => {
    expect(() => forced({ checksum: 65536 })).toThrow(expect.objectContaining({ field: 'checksum' }));
    expect(() => forced({ checksum: 'no' })).toThrow(expect.objectContaining({ field: 'checksum' }));
    expect(() => forced({ unitId: 'no' })).toThrow(expect.objectContaining({ field: 'unitId' }));
    expect(() => forced({ after: 'no' })).toThrow(expect.objectContaining({ field: 'after' }));
  });
  test('its CRC is computed over what is forced', () => {
    expect(forced({ quantity: 4 })).toBe(same('11 03 006B 0004 3745'));
  });
  test('its unit', () => {
    expect(forced({ unitId: 0xff, checksum: '' })).toBe(same('FF 03 006B 0003'));
    expect(forced({ unitId: '', checksum: '' })).toBe(same('03 006B 0003'));
  });
  test('bytes behind it', () => {
    expect(forced({ after: '00' })).toBe(same('11 03 006B 0003 7687 00'));
  });
});

describe('a TCP frame with something forced', () => {
  const forced = (force: FrameInput['force']) => bytesOf({ ...read, transactionId: 1, transport: 'tcp', force });

  test('its header', () => {
    expect(forced({})).toBe(same('0001 0000 0006 11 03 006B 0003'));
    expect(forced({ length: 7 })).toBe(same('0001 0000 0007 11 03 006B 0003'));
    expect(forced({ length: '00' })).toBe(same('0001 0000 00 11 03 006B 0003'));
    expect(forced({ protocolId: 0x1234 })).toBe(same('0001 1234 0006 11 03 006B 0003'));
    expect(forced({ transactionId: 0xffff })).toBe(same('FFFF 0000 0006 11 03 006B 0003'));
    expect(() => forced({ length: 65536 })).toThrow(FrameError);
    expect(() => forced({ protocolId: -1 })).toThrow(FrameError);
  });
  test('what the length field counts: the unit, the PDU and its rest, nothing behind', () => {
    expect(forced({ rest: 'AABB' })).toBe(same('0001 0000 0008 11 03 006B 0003 AABB'));
    expect(forced({ after: 'AABB' })).toBe(same('0001 0000 0006 11 03 006B 0003 AABB'));
    expect(forced({ quantity: '' })).toBe(same('0001 0000 0004 11 03 006B'));
  });
});

describe('an ASCII frame with something forced', () => {
  const forced = (force: FrameInput['force']) =>
    Buffer.from(encodeFrame({ ...read, transport: 'ascii', force })).toString('latin1');
  const asHex = (text: string) => toHex(characters(text));

  test('its LRC, as a number or as bytes', () => {
    expect(forced({})).toBe(':1103006B00037E\r\n');
    expect(forced({ checksum: 0x0f })).toBe(':1103006B00030F\r\n');
    expect(forced({ checksum: 'ABCD' })).toBe(':1103006B0003ABCD\r\n');
    expect(forced({ checksum: '' })).toBe(':1103006B0003\r\n');
    expect(() => forced({ checksum: 256 })).toThrow(FrameError);
  });
  test('what has no bytes is named', () => {
    for (const field of ['start', 'characters', 'end', 'after']) {
      expect(() => forced({ [field]: 'no' }), field).toThrow(expect.objectContaining({ field }));
    }
  });
  test('its characters need no fields that have bytes', () => {
    const broken = { ...read, unitId: 70000, transport: 'ascii' as const, force: { characters: '3132' } };
    expect(Buffer.from(encodeFrame(broken)).toString('latin1')).toBe(':12\r\n');
  });
  test('its parts', () => {
    expect(forced({ start: '' })).toBe('1103006B00037E\r\n');
    expect(forced({ start: asHex('> :') })).toBe('> :1103006B00037E\r\n');
    expect(forced({ end: '' })).toBe(':1103006B00037E');
    expect(forced({ end: '0A' })).toBe(':1103006B00037E\n');
    expect(forced({ characters: asHex('1103006b00037e') })).toBe(':1103006b00037e\r\n');
    expect(forced({ after: asHex(':') })).toBe(':1103006B00037E\r\n:');
  });
});

describe('what the encoder works out is not taken from the fields', () => {
  test.each([
    ['rtu', '11 10 0001 0002 04 000A 0102 C6F0'],
    ['tcp', '0000 0000 000B 11 10 0001 0002 04 000A 0102'],
    ['pdu', '10 0001 0002 04 000A 0102'],
  ] as const)('%s', (transport, text) => {
    const derived = { quantity: 9, byteCount: 'many', checksum: 1, length: -1, protocolId: 7, rest: 'AA' };
    expect(bytesOf({ ...write, transport, fields: { ...write.fields, ...derived } })).toBe(same(text));
  });

  test('nor is a name it does not know', () => {
    expect(bytesOf({ ...read, transport: 'rtu', fields: { ...read.fields, sensor: 'inlet' } })).toBe(
      same('11 03 006B 0003 7687'),
    );
  });
});
