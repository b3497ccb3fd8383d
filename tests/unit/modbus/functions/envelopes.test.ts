import { expect, test } from 'vitest';
import { decodeFrame, encodeFrame, type FrameInput } from '../../../../src/modbus/index.ts';
import { characters, hex, said } from '../frames.ts';

const readThree = { direction: 'request', functionCode: 3, fields: { startAddress: 107, quantity: 3 } } as const;
const inputs: readonly { what: string; input: FrameInput; bytes: Uint8Array; derived: Record<string, number> }[] = [
  {
    what: 'RTU (SL 2.5.1)',
    input: { ...readThree, transport: 'rtu', unitId: 0x11 },
    bytes: Uint8Array.of(
      0x11, // unit
      0x03, // function code
      ...[0x00, 0x6b], // start address
      ...[0x00, 0x03], // quantity
      ...[0x76, 0x87], // CRC, low byte first
    ),
    derived: { checksum: 0x8776 },
  },
  {
    what: 'ASCII (SL 2.5.2)',
    input: { ...readThree, transport: 'ascii', unitId: 0x11 },
    bytes: characters(':1103006B00037E\r\n'),
    derived: { checksum: 0x7e },
  },
  {
    what: 'TCP (TG 4.4.1.2)',
    input: {
      transport: 'tcp',
      direction: 'request',
      transactionId: 0x1501,
      unitId: 0xff,
      functionCode: 3,
      fields: { startAddress: 4, quantity: 1 },
    },
    bytes: Uint8Array.of(
      ...[0x15, 0x01], // transaction identifier
      ...[0x00, 0x00], // protocol identifier
      ...[0x00, 0x06], // length
      0xff, // unit
      0x03, // function code
      ...[0x00, 0x04], // start address
      ...[0x00, 0x01], // quantity
    ),
    derived: { protocolId: 0, length: 6 },
  },
  {
    what: 'a bare PDU (AP 4.1)',
    input: { ...readThree, transport: 'pdu' },
    bytes: hex('03 006B 0003'),
    derived: {},
  },
];

test.each(inputs)('$what, both ways', ({ input, bytes, derived }) => {
  expect(encodeFrame(input)).toEqual(bytes);
  const { transport, direction } = input;
  const reading = decodeFrame(bytes, { transport, direction });
  expect(reading).toMatchObject({ ...input, derived, outcome: { kind: 'whole' }, forced: {} });
  expect(said(reading)).toEqual([]);
});

test('the transaction identifier is 0 where it is left out', () => {
  expect(encodeFrame({ ...readThree, transport: 'tcp', unitId: 1 })).toEqual(hex('0000 0000 0006 01 03 006B 0003'));
});

test('where each field stands, in bytes and in characters', () => {
  const places = (bytes: Uint8Array, transport: FrameInput['transport']) =>
    decodeFrame(bytes, { transport, direction: 'request' }).spans.map(({ name, from, to }) => `${name} ${from}-${to}`);
  expect(places(hex('11 03 006B 0003 7687'), 'rtu')).toEqual([
    'unitId 0-1',
    'functionCode 1-2',
    'startAddress 2-4',
    'quantity 4-6',
    'checksum 6-8',
  ]);
  expect(places(characters(':1103006B00037E\r\n'), 'ascii')).toEqual([
    'start 0-1',
    'unitId 1-3',
    'functionCode 3-5',
    'startAddress 5-9',
    'quantity 9-13',
    'checksum 13-15',
    'end 15-17',
  ]);
  expect(places(hex('1501 0000 0006 FF 03 0004 0001'), 'tcp')).toEqual([
    'transactionId 0-2',
    'protocolId 2-4',
    'length 4-6',
    'unitId 6-7',
    'functionCode 7-8',
    'startAddress 8-10',
    'quantity 10-12',
  ]);
});
