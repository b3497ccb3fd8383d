import { test } from 'vitest';
import { expectBothWays, type LiteralPdu } from '../frames.ts';

const both = ['request', 'response'] as const;

// biome-ignore format: a line a field
const pdus: readonly LiteralPdu[] = [
  {
    what: 'AP 6.3: read holding registers 108 to 110',
    direction: 'request',
    bytes: [
      0x03, // function code
      0x00, 0x6b, // start address: register 108
      0x00, 0x03, // quantity
    ],
    fields: { startAddress: 107, quantity: 3 },
  },
  {
    what: 'AP 6.3: holding registers 108 to 110',
    direction: 'response',
    request: [0x03, 0x00, 0x6b, 0x00, 0x03],
    bytes: [
      0x03, // function code
      0x06, // byte count
      0x02, 0x2b, // register 108
      0x00, 0x00, // register 109
      0x00, 0x64, // register 110
    ],
    fields: { registers: [555, 0, 100] },
    derived: { byteCount: 6 },
  },
  {
    what: 'AP 6.4: read input register 9',
    direction: 'request',
    bytes: [
      0x04, // function code
      0x00, 0x08, // start address: register 9
      0x00, 0x01, // quantity
    ],
    fields: { startAddress: 8, quantity: 1 },
  },
  {
    what: 'AP 6.4: input register 9',
    direction: 'response',
    request: [0x04, 0x00, 0x08, 0x00, 0x01],
    bytes: [
      0x04, // function code
      0x02, // byte count
      0x00, 0x0a, // register 9
    ],
    fields: { registers: [10] },
    derived: { byteCount: 2 },
  },
  ...both.map((direction) => ({
    what: 'AP 6.6: register 2 becomes 3',
    direction,
    bytes: [
      0x06, // function code
      0x00, 0x01, // address: register 2
      0x00, 0x03, // value
    ],
    fields: { address: 1, value: 3 },
  })),
  {
    what: 'AP 6.12: two registers from register 2',
    direction: 'request',
    bytes: [
      0x10, // function code
      0x00, 0x01, // start address: register 2
      0x00, 0x02, // quantity
      0x04, // byte count
      0x00, 0x0a, // register 2
      0x01, 0x02, // register 3
    ],
    fields: { startAddress: 1, registers: [10, 258] },
    derived: { quantity: 2, byteCount: 4 },
  },
  {
    what: 'AP 6.12: two registers written',
    direction: 'response',
    bytes: [
      0x10, // function code
      0x00, 0x01, // start address
      0x00, 0x02, // quantity
    ],
    fields: { startAddress: 1, quantity: 2 },
  },
  ...both.map((direction) => ({
    what: 'AP 6.16: mask register 5',
    direction,
    bytes: [
      0x16, // function code
      0x00, 0x04, // reference address: register 5
      0x00, 0xf2, // AND mask
      0x00, 0x25, // OR mask
    ],
    fields: { referenceAddress: 4, andMask: 0xf2, orMask: 0x25 },
  })),
  {
    what: 'AP 6.17: read six from register 4, write three from register 15',
    direction: 'request',
    bytes: [
      0x17, // function code
      0x00, 0x03, // read start address: register 4
      0x00, 0x06, // read quantity
      0x00, 0x0e, // write start address: register 15
      0x00, 0x03, // write quantity
      0x06, // write byte count
      0x00, 0xff, // register 15
      0x00, 0xff, // register 16
      0x00, 0xff, // register 17
    ],
    fields: { readStartAddress: 3, readQuantity: 6, writeStartAddress: 14, writeRegisters: [255, 255, 255] },
    derived: { writeQuantity: 3, writeByteCount: 6 },
  },
  {
    what: 'AP 6.17: six registers from register 4',
    direction: 'response',
    bytes: [
      0x17, // function code
      0x0c, // byte count
      0x00, 0xfe, // register 4
      0x0a, 0xcd, // register 5
      0x00, 0x01, // register 6
      0x00, 0x03, // register 7
      0x00, 0x0d, // register 8
      0x00, 0xff, // register 9
    ],
    fields: { registers: [254, 2765, 1, 3, 13, 255] },
    derived: { byteCount: 12 },
  },
  {
    what: 'AP 6.18: read the queue at 04DE',
    direction: 'request',
    bytes: [
      0x18, // function code
      0x04, 0xde, // FIFO pointer address
    ],
    fields: { fifoPointerAddress: 1246 },
  },
  {
    what: 'AP 6.18: two values from the queue',
    direction: 'response',
    bytes: [
      0x18, // function code
      0x00, 0x06, // byte count
      0x00, 0x02, // FIFO count
      0x01, 0xb8, // first value
      0x12, 0x84, // second value
    ],
    fields: { fifoValues: [440, 4740] },
    derived: { byteCount: 6, fifoCount: 2 },
  },
  {
    what: 'AP 6.18: an empty queue',
    direction: 'response',
    bytes: [
      0x18, // function code
      0x00, 0x02, // byte count
      0x00, 0x00, // FIFO count
    ],
    fields: { fifoValues: [] },
    derived: { byteCount: 2, fifoCount: 0 },
  },
];

test.each(pdus)('$what ($direction)', expectBothWays);
