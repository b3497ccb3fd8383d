import { expect, test } from 'vitest';
import { encodeFrame } from '../../../../src/modbus/index.ts';
import { expectBothWays, type LiteralPdu } from '../frames.ts';

const both = ['request', 'response'] as const;

// biome-ignore format: a line a field
const pdus: readonly LiteralPdu[] = [
  {
    what: 'AP 6.14: read two groups of file records',
    direction: 'request',
    bytes: [
      0x14, // function code
      0x0e, // byte count
      0x06, // reference type
      0x00, 0x04, // file number
      0x00, 0x01, // record number
      0x00, 0x02, // record length
      0x06, // reference type
      0x00, 0x03, // file number
      0x00, 0x09, // record number
      0x00, 0x02, // record length
    ],
    fields: {
      subRequests: [
        { referenceType: 6, fileNumber: 4, recordNumber: 1, recordLength: 2 },
        { referenceType: 6, fileNumber: 3, recordNumber: 9, recordLength: 2 },
      ],
    },
    derived: { byteCount: 14 },
  },
  {
    what: 'AP 6.14: two groups of file records',
    direction: 'response',
    bytes: [
      0x14, // function code
      0x0c, // response data length
      0x05, // file response length
      0x06, // reference type
      0x0d, 0xfe, 0x00, 0x20, // records
      0x05, // file response length
      0x06, // reference type
      0x33, 0xcd, 0x00, 0x40, // records
    ],
    fields: {
      subResponses: [
        { referenceType: 6, recordData: [0x0dfe, 0x0020] },
        { referenceType: 6, recordData: [0x33cd, 0x0040] },
      ],
    },
    derived: { responseDataLength: 12 },
  },
  ...both.map((direction) => ({
    what: 'AP 6.15: write three records of file 4',
    direction,
    bytes: [
      0x15, // function code
      0x0d, // data length
      0x06, // reference type
      0x00, 0x04, // file number
      0x00, 0x07, // record number
      0x00, 0x03, // record length
      0x06, 0xaf, 0x04, 0xbe, 0x10, 0x0d, // records
    ],
    fields: {
      subRequests: [{ referenceType: 6, fileNumber: 4, recordNumber: 7, recordData: [0x06af, 0x04be, 0x100d] }],
    },
    derived: { dataLength: 13 },
  })),
  ...both.map((direction) => ({
    what: 'AP 6.20: CANopen general reference, its body raw',
    direction,
    bytes: [
      0x2b, // function code
      0x0d, // MEI type
      0x00, 0x11, 0x22, // body
    ],
    fields: { meiType: 13, meiData: '001122' },
  })),
  {
    what: 'AP 6.21: read the basic identification',
    direction: 'request',
    bytes: [
      0x2b, // function code
      0x0e, // MEI type
      0x01, // read device id code: basic
      0x00, // object id
    ],
    fields: { meiType: 14, readDeviceIdCode: 1, objectId: 0 },
  },
  {
    what: 'AP 6.21: the basic identification, its lengths put right',
    direction: 'response',
    bytes: [
      0x2b, // function code
      0x0e, // MEI type
      0x01, // read device id code
      0x01, // conformity level
      0x00, // more follows: no
      0x00, // next object id
      0x03, // number of objects
      0x00, // object id: VendorName
      0x04, // length
      0x41, 0x43, 0x4d, 0x45, // ACME
      0x01, // object id: ProductCode
      0x02, // length
      0x50, 0x31, // P1
      0x02, // object id: MajorMinorRevision
      0x05, // length
      0x56, 0x32, 0x2e, 0x31, 0x31, // V2.11
    ],
    fields: {
      meiType: 14,
      readDeviceIdCode: 1,
      conformityLevel: 1,
      moreFollows: 0,
      nextObjectId: 0,
      objects: [
        { objectId: 0, valueHex: '41434D45', value: 'ACME' },
        { objectId: 1, valueHex: '5031', value: 'P1' },
        { objectId: 2, valueHex: '56322E3131', value: 'V2.11' },
      ],
    },
    derived: { numberOfObjects: 3 },
  },
  {
    what: 'AP 6.21: a private object that is no text, more to follow',
    direction: 'response',
    bytes: [
      0x2b, // function code
      0x0e, // MEI type
      0x03, // read device id code: extended
      0x83, // conformity level
      0xff, // more follows: yes
      0x81, // next object id
      0x01, // number of objects
      0x80, // object id: private
      0x02, // length
      0x00, 0xff, // value
    ],
    fields: {
      meiType: 14,
      readDeviceIdCode: 3,
      conformityLevel: 0x83,
      moreFollows: 0xff,
      nextObjectId: 0x81,
      objects: [{ objectId: 0x80, valueHex: '00FF' }],
    },
    derived: { numberOfObjects: 1 },
  },
];

test.each(pdus)('$what ($direction)', expectBothWays);

test('an object is encoded from its text as well', () => {
  const fields = {
    meiType: 14,
    readDeviceIdCode: 4,
    conformityLevel: 0x81,
    moreFollows: 0,
    nextObjectId: 0,
    objects: [{ objectId: 2, value: 'V1' }],
  };
  expect(Array.from(encodeFrame({ transport: 'pdu', direction: 'response', functionCode: 0x2b, fields }))).toEqual([
    0x2b, 0x0e, 0x04, 0x81, 0x00, 0x00, 0x01, 0x02, 0x02, 0x56, 0x31,
  ]);
});
