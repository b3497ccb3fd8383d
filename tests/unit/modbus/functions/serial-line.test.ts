import { test } from 'vitest';
import { expectBothWays, type LiteralPdu } from '../frames.ts';

const both = ['request', 'response'] as const;

// biome-ignore format: a line a field
const pdus: readonly LiteralPdu[] = [
  { what: 'AP 6.7: read exception status', direction: 'request', bytes: [0x07], fields: {} },
  {
    what: 'AP 6.7: the eight exception outputs',
    direction: 'response',
    bytes: [
      0x07, // function code
      0x6d, // outputs 8…1: 0110 1101
    ],
    fields: { outputData: 0x6d },
  },
  ...both.map((direction) => ({
    what: 'AP 6.8: return query data',
    direction,
    bytes: [
      0x08, // function code
      0x00, 0x00, // sub-function
      0xa5, 0x37, // data
    ],
    fields: { subFunction: 0, data: 'A537' },
  })),
  ...both.map((direction) => ({
    what: 'AP 6.8: return query data, two words',
    direction,
    bytes: [
      0x08, // function code
      0x00, 0x00, // sub-function
      0xa5, 0x37, 0x12, 0x34, // data
    ],
    fields: { subFunction: 0, data: 'A5371234' },
    notes: ['note diagnostics-length-open'],
  })),
  {
    what: 'AP 6.8.1: restart communications and clear the event log',
    direction: 'request',
    bytes: [
      0x08, // function code
      0x00, 0x01, // sub-function
      0xff, 0x00, // data
    ],
    fields: { subFunction: 1, data: 'FF00' },
  },
  {
    what: 'AP 6.8.1: return diagnostic register',
    direction: 'request',
    bytes: [
      0x08, // function code
      0x00, 0x02, // sub-function
      0x00, 0x00, // data
    ],
    fields: { subFunction: 2, data: '0000' },
  },
  {
    what: 'AP 6.8.1: the diagnostic register',
    direction: 'response',
    bytes: [
      0x08, // function code
      0x00, 0x02, // sub-function
      0x12, 0x34, // diagnostic register
    ],
    fields: { subFunction: 2, data: '1234' },
  },
  ...both.map((direction) => ({
    what: 'AP 6.8.1: change the ASCII input delimiter to ;',
    direction,
    bytes: [
      0x08, // function code
      0x00, 0x03, // sub-function
      0x3b, 0x00, // the character and 00
    ],
    fields: { subFunction: 3, data: '3B00' },
  })),
  {
    what: 'AP 6.8.1: force listen only mode',
    direction: 'request',
    bytes: [
      0x08, // function code
      0x00, 0x04, // sub-function
      0x00, 0x00, // data
    ],
    fields: { subFunction: 4, data: '0000' },
  },
  {
    what: 'AP 6.8.1: bus messages counted',
    direction: 'response',
    bytes: [
      0x08, // function code
      0x00, 0x0b, // sub-function
      0x01, 0x08, // count
    ],
    fields: { subFunction: 11, data: '0108' },
  },
  { what: 'AP 6.9: get comm event counter', direction: 'request', bytes: [0x0b], fields: {} },
  {
    what: 'AP 6.9: busy, 264 events',
    direction: 'response',
    bytes: [
      0x0b, // function code
      0xff, 0xff, // status
      0x01, 0x08, // event count
    ],
    fields: { status: 0xffff, eventCount: 264 },
  },
  { what: 'AP 6.10: get comm event log', direction: 'request', bytes: [0x0c], fields: {} },
  {
    what: 'AP 6.10: 264 events, 289 messages, two event bytes',
    direction: 'response',
    bytes: [
      0x0c, // function code
      0x08, // byte count
      0x00, 0x00, // status
      0x01, 0x08, // event count
      0x01, 0x21, // message count
      0x20, // the newest event
      0x00, // the one before
    ],
    fields: { status: 0, eventCount: 264, messageCount: 289, events: [0x20, 0x00] },
    derived: { byteCount: 8 },
  },
  { what: 'AP 6.13: report server ID', direction: 'request', bytes: [0x11], fields: {} },
  {
    what: 'AP 6.13: a server id, running, and two more bytes',
    direction: 'response',
    bytes: [
      0x11, // function code
      0x04, // byte count
      0x09, // server id
      0xff, // run indicator: on
      0x01, 0x02, // additional data
    ],
    fields: { data: '09FF0102' },
    derived: { byteCount: 4 },
    notes: ['note server-id-layout-open'],
  },
];

test.each(pdus)('$what ($direction)', expectBothWays);
