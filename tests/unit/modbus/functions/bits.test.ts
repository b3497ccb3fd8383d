import { test } from 'vitest';
import { expectBothWays, type LiteralPdu } from '../frames.ts';

// biome-ignore format: a line a field
const pdus: readonly LiteralPdu[] = [
  {
    what: 'AP 6.1: read coils 20 to 38',
    direction: 'request',
    bytes: [
      0x01, // function code
      0x00, 0x13, // start address: coil 20
      0x00, 0x13, // quantity
    ],
    fields: { startAddress: 19, quantity: 19 },
  },
  {
    what: 'AP 6.1: coils 20 to 38, the request known',
    direction: 'response',
    request: [0x01, 0x00, 0x13, 0x00, 0x13],
    bytes: [
      0x01, // function code
      0x03, // byte count
      0xcd, // coils 27…20
      0x6b, // coils 35…28
      0x05, // coils 38…36
    ],
    fields: { bits: [1, 0, 1, 1, 0, 0, 1, 1, 1, 1, 0, 1, 0, 1, 1, 0, 1, 0, 1] },
    derived: { byteCount: 3 },
  },
  {
    what: 'AP 6.1: the same, the request unknown',
    direction: 'response',
    bytes: [
      0x01, // function code
      0x03, // byte count
      0xcd, // coils 27…20
      0x6b, // coils 35…28
      0x05, // coils 38…36 and padding
    ],
    fields: { bits: [1, 0, 1, 1, 0, 0, 1, 1, 1, 1, 0, 1, 0, 1, 1, 0, 1, 0, 1, 0, 0, 0, 0, 0] },
    derived: { byteCount: 3 },
  },
  {
    what: 'AP 6.2: read discrete inputs 197 to 218',
    direction: 'request',
    bytes: [
      0x02, // function code
      0x00, 0xc4, // start address: input 197
      0x00, 0x16, // quantity
    ],
    fields: { startAddress: 196, quantity: 22 },
  },
  {
    what: 'AP 6.2: inputs 197 to 218',
    direction: 'response',
    request: [0x02, 0x00, 0xc4, 0x00, 0x16],
    bytes: [
      0x02, // function code
      0x03, // byte count
      0xac, // inputs 204…197
      0xdb, // inputs 212…205
      0x35, // inputs 218…213
    ],
    fields: { bits: [0, 0, 1, 1, 0, 1, 0, 1, 1, 1, 0, 1, 1, 0, 1, 1, 1, 0, 1, 0, 1, 1] },
    derived: { byteCount: 3 },
  },
  ...(['request', 'response'] as const).map((direction) => ({
    what: 'AP 6.5: coil 173 on',
    direction,
    bytes: [
      0x05, // function code
      0x00, 0xac, // address: coil 173
      0xff, 0x00, // value: on
    ],
    fields: { address: 172, value: true },
    derived: { rawValue: 0xff00 },
  })),
  {
    what: 'AP 6.5: a coil off',
    direction: 'request',
    bytes: [
      0x05, // function code
      0x00, 0xac, // address
      0x00, 0x00, // value: off
    ],
    fields: { address: 172, value: false },
    derived: { rawValue: 0 },
  },
  {
    what: 'AP 6.11: ten coils from coil 20',
    direction: 'request',
    bytes: [
      0x0f, // function code
      0x00, 0x13, // start address: coil 20
      0x00, 0x0a, // quantity
      0x02, // byte count
      0xcd, // coils 27…20
      0x01, // coils 29…28
    ],
    fields: { startAddress: 19, bits: [1, 0, 1, 1, 0, 0, 1, 1, 1, 0] },
    derived: { quantity: 10, byteCount: 2 },
  },
  {
    what: 'AP 6.11: ten coils written',
    direction: 'response',
    bytes: [
      0x0f, // function code
      0x00, 0x13, // start address
      0x00, 0x0a, // quantity
    ],
    fields: { startAddress: 19, quantity: 10 },
  },
  {
    what: 'AP 7: read coils refused, no such address',
    direction: 'response',
    bytes: [
      0x81, // function code with the exception bit
      0x02, // ILLEGAL DATA ADDRESS
    ],
    fields: { exceptionCode: 2 },
  },
];

test.each(pdus)('$what ($direction)', expectBothWays);
