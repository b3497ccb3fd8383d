import { describe, expect, test } from 'vitest';
import { type Direction, encodeFrame, FrameError, type FrameInput, type Transport } from '../../../src/modbus/index.ts';

const attempt = (input: FrameInput): FrameError => {
  try {
    encodeFrame(input);
  } catch (error) {
    if (error instanceof FrameError) return error;
    throw error;
  }
  throw new Error('it has bytes');
};

const pdu = (functionCode: number, fields: Record<string, unknown>, direction: Direction = 'request'): FrameInput => ({
  transport: 'pdu',
  direction,
  functionCode,
  fields,
});

const refusal = (input: FrameInput) => {
  const { field, code } = attempt(input);
  return `${field}: ${code}`;
};

describe('what has no bytes in 16 bits', () => {
  test.each([70000, 65536, -1, 1.5, Number.NaN, Number.POSITIVE_INFINITY, 'abc', '1', null, true, [1], {}])(
    '%j',
    (got) => {
      const error = attempt(pdu(0x06, { address: got, value: 1 }));
      expect(error.field).toBe('address');
      expect(error.reason).toEqual({ code: 'number-out-of-range', least: 0, most: 65535, got });
      expect(refusal(pdu(0x06, { address: 0, value: got }))).toBe('value: number-out-of-range');
    },
  );

  test('nothing at all', () => {
    expect(refusal(pdu(0x06, { value: 1 }))).toBe('address: field-missing');
    expect(refusal(pdu(0x06, { address: undefined, value: 1 }))).toBe('address: field-missing');
  });

  test('65535 and 0 have', () => {
    expect(Array.from(encodeFrame(pdu(0x06, { address: 65535, value: 0 })))).toEqual([6, 0xff, 0xff, 0, 0]);
  });
});

test('the message names the field, the value and what would do', () => {
  const error = attempt(pdu(0x06, { address: 70000, value: 1 }));
  expect(error).toBeInstanceOf(Error);
  expect(error.name).toBe('FrameError');
  expect(error.message).toBe('address: 70000 is not a whole number from 0 to 65535');
});

describe('a byte', () => {
  test.each([256, -1, 0.5, '7', null])('%j has none', (got) => {
    expect(attempt(pdu(0x07, { outputData: got }, 'response')).reason).toEqual({
      code: 'number-out-of-range',
      least: 0,
      most: 255,
      got,
    });
  });
});

describe('lists', () => {
  const write = (registers: unknown) => refusal(pdu(0x10, { startAddress: 0, registers }));
  const coils = (bits: unknown) => refusal(pdu(0x0f, { startAddress: 0, bits }));

  test('name the item that has no bytes', () => {
    expect(write([1, 2, 3, 65536])).toBe('registers[3]: number-out-of-range');
    expect(write([1, -1])).toBe('registers[1]: number-out-of-range');
    expect(write([1.5])).toBe('registers[0]: number-out-of-range');
    expect(write([1, undefined])).toBe('registers[1]: field-missing');
    expect(write([null])).toBe('registers[0]: number-out-of-range');
    expect(write(['1'])).toBe('registers[0]: number-out-of-range');
    const log = { status: 0, eventCount: 0, messageCount: 0 };
    expect(refusal(pdu(0x0c, { ...log, events: [1, 256] }, 'response'))).toBe('events[1]: number-out-of-range');
  });

  test('of bits hold 0, 1, true and false', () => {
    expect(Array.from(encodeFrame(pdu(0x0f, { startAddress: 0, bits: [1, false, true, 0] })))).toEqual([
      0x0f, 0, 0, 0, 4, 1, 0b0101,
    ]);
    expect(coils([1, 0, 2])).toBe('bits[2]: not-a-flag');
    expect(coils([undefined])).toBe('bits[0]: field-missing');
    expect(coils(['1'])).toBe('bits[0]: not-a-flag');
  });

  test('too long for their byte count have no bytes: 128 registers make 256', () => {
    const registers = new Array<number>(128).fill(0);
    const error = attempt(pdu(0x10, { startAddress: 0, registers }));
    expect(error.field).toBe('byteCount');
    expect(error.reason).toMatchObject({ code: 'number-out-of-range', most: 255, got: 256 });
    expect(encodeFrame(pdu(0x10, { startAddress: 0, registers: registers.slice(1) }))).toHaveLength(260);
    expect(refusal(pdu(0x03, { registers }, 'response'))).toBe('byteCount: number-out-of-range');
    expect(refusal(pdu(0x0f, { startAddress: 0, bits: new Array(2041).fill(0) }))).toBe(
      'byteCount: number-out-of-range',
    );
  });
});

test('a coil is a flag', () => {
  for (const value of [2, 'on', null, 0xff00]) {
    expect(refusal(pdu(0x05, { address: 0, value }))).toBe('value: not-a-flag');
  }
  expect(refusal(pdu(0x05, { address: 0 }))).toBe('value: field-missing');
});

test('raw data is pairs of hexadecimal digits', () => {
  const raw = (data: unknown) => refusal(pdu(0x41, { data }));
  for (const data of ['ABC', 'XY', '0x12', 12, null, [1]]) expect(raw(data)).toBe('data: not-hex');
  expect(raw(undefined)).toBe('data: field-missing');
  expect(Array.from(encodeFrame(pdu(0x41, { data: 'ab CD\n01' })))).toEqual([0x41, 0xab, 0xcd, 1]);
  expect(Array.from(encodeFrame(pdu(0x41, { data: '' })))).toEqual([0x41]);
});

describe('groups', () => {
  const record = { referenceType: 6, fileNumber: 1, recordNumber: 0, recordLength: 1 };
  const read = (...subRequests: unknown[]) => refusal(pdu(0x14, { subRequests }));
  const identify = (...objects: unknown[]) => {
    const header = { meiType: 14, readDeviceIdCode: 1, conformityLevel: 1, moreFollows: 0, nextObjectId: 0 };
    return refusal(pdu(0x2b, { ...header, objects }, 'response'));
  };

  test('name the group and the field', () => {
    expect(read(record, { ...record, fileNumber: 70000 })).toBe('subRequests[1].fileNumber: number-out-of-range');
    expect(read({ ...record, recordLength: undefined })).toBe('subRequests[0].recordLength: field-missing');
    expect(read(7)).toBe('subRequests[0]: not-a-list');
    const written = { referenceType: 6, fileNumber: 1, recordNumber: 0, recordData: [1, 65536] };
    expect(refusal(pdu(0x15, { subRequests: [written] }))).toBe('subRequests[0].recordData[1]: number-out-of-range');
    expect(refusal(pdu(0x14, { subResponses: [{ referenceType: 6, recordData: [-1] }] }, 'response'))).toBe(
      'subResponses[0].recordData[0]: number-out-of-range',
    );
  });

  test('of device identification have a value in ASCII or in hexadecimal, of 255 bytes at most', () => {
    expect(identify({ objectId: 0, value: 'é' })).toBe('objects[0].value: not-ascii');
    expect(identify({ objectId: 0, valueHex: '4' })).toBe('objects[0].valueHex: not-hex');
    expect(identify({ objectId: 0 })).toBe('objects[0].valueHex: field-missing');
    expect(identify({ objectId: 256, value: '' })).toBe('objects[0].objectId: number-out-of-range');
    expect(identify({ objectId: 0, value: 'A'.repeat(256) })).toBe('objects[0].length: number-out-of-range');
  });
});

describe('the envelope', () => {
  const read = { direction: 'request', functionCode: 3, fields: { startAddress: 0, quantity: 1 } } as const;

  test.each<Transport>(['rtu', 'ascii', 'tcp'])('%s: a unit is one byte', (transport) => {
    for (const unitId of [256, -1, 1.5, Number.NaN]) {
      expect(refusal({ ...read, transport, unitId })).toBe('unitId: number-out-of-range');
    }
    expect(refusal({ ...read, transport })).toBe('unitId: field-missing');
  });

  test('a transaction is two bytes', () => {
    for (const transactionId of [65536, -1, 0.5]) {
      expect(refusal({ ...read, transport: 'tcp', unitId: 1, transactionId })).toBe(
        'transactionId: number-out-of-range',
      );
    }
  });

  test('a function code is one byte', () => {
    expect(refusal({ ...read, transport: 'pdu', functionCode: 256 })).toBe('functionCode: number-out-of-range');
    expect(refusal({ ...read, transport: 'pdu', functionCode: undefined })).toBe('functionCode: field-missing');
  });

  test('the length field of TCP is two bytes', () => {
    const tcp = { ...read, transport: 'tcp', unitId: 1 } as const;
    const error = attempt({ ...tcp, force: { rest: '00'.repeat(65530) } });
    expect(error.field).toBe('length');
    expect(error.reason).toMatchObject({ code: 'number-out-of-range', most: 65535, got: 65536 });
    expect(encodeFrame({ ...tcp, force: { rest: '00'.repeat(65529) } })).toHaveLength(65541);
    expect(encodeFrame({ ...tcp, force: { rest: '00'.repeat(65530), length: 0 } })).toHaveLength(65542);
  });

  test('a transport that does not exist is a mistake of the program, not of the frame', () => {
    const transport = 'udp' as Transport;
    expect(() => encodeFrame({ ...read, transport })).toThrow(
      new TypeError(`transport: ${transport} is not rtu, ascii, tcp or pdu`),
    );
  });
});

describe('what breaks a rule has bytes', () => {
  test.each([
    ['126 registers asked', pdu(0x03, { startAddress: 0, quantity: 126 }), '030000007E'],
    ['none asked', pdu(0x01, { startAddress: 0, quantity: 0 }), '0100000000'],
    ['none written', pdu(0x10, { startAddress: 0, registers: [] }), '100000000000'],
    ['beyond the last address', pdu(0x03, { startAddress: 65535, quantity: 2 }), '03FFFF0002'],
    ['function code 0', pdu(0, { data: '01' }), '0001'],
    ['an undefined exception', pdu(0x83, { exceptionCode: 0 }, 'response'), '8300'],
    ['a reserved reference type', pdu(0x14, { subRequests: [] }), '1400'],
    ['a reserved MEI type', pdu(0x2b, { meiType: 0, meiData: 'AA' }), '2B00AA'],
    ['data that is not 0000', pdu(0x08, { subFunction: 2, data: '0001' }), '0800020001'],
  ])('%s', (_what, input, bytes) => {
    expect(Buffer.from(encodeFrame(input)).toString('hex').toUpperCase()).toBe(bytes);
  });
});
