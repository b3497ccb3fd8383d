import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { type FrameAt, framesAt } from '../../../src/modbus/index.ts';
import { anyBytes } from './arbitraries.ts';
import { characters, hex, zeros } from './frames.ts';
import { asAscii, asRtu, asTcp } from './reference.ts';
import { frames } from './vectors.ts';

/** `rtu request 0-8`, with what is not legal and what is open said behind it. */
const say = ({ transport, direction, from, to, legal, open }: FrameAt) =>
  `${transport} ${direction} ${from}-${to}${legal ? '' : ' illegal'}${open ? ' open' : ''}`;

const at = (bytes: Uint8Array, place = 0, end?: number) => framesAt(bytes, place, end).map(say);

const READ = [
  0x01,
  0x03, // unit, function code
  0x01,
  0x80, // start address
  0x00,
  0x0a, // quantity
  0xc5,
  0xd9, // CRC
];
const READ_REPLY = [
  0x11,
  0x03, // unit, function code
  0x06, // byte count
  0xae,
  0x41,
  0x56,
  0x52,
  0x43,
  0x40, // registers
  0x49,
  0xad, // CRC
];

describe('RTU', () => {
  test.each([
    { what: 'a request to read', hex: '01 03 01 80 00 0A C5 D9', found: ['rtu request 0-8'] },
    { what: 'a reply with registers', hex: '11 03 06 AE41 5652 4340 49AD', found: ['rtu response 0-11'] },
    { what: 'a request to write registers', hex: '11 10 0001 0002 04 000A 0102 C6F0', found: ['rtu request 0-13'] },
    { what: 'its reply', hex: '11 10 0001 0002 1298', found: ['rtu response 0-8'] },
    { what: 'an exception', hex: '11 81 01 8055', found: ['rtu request 0-5 illegal open', 'rtu response 0-5'] },
    {
      what: 'a write that its reply echoes',
      hex: '11 06 0001 0003 9A9B',
      found: ['rtu request 0-8', 'rtu response 0-8'],
    },
  ])('$what', ({ hex: text, found }) => {
    expect(at(hex(text))).toEqual(found);
  });

  test('found at its place among other bytes, in either direction', () => {
    const bytes = Uint8Array.of(0xff, ...READ, ...READ_REPLY, 0xff);
    expect(at(bytes, 1)).toEqual(['rtu request 1-9']);
    expect(at(bytes, 9)).toEqual(['rtu response 9-20']);
    for (const place of [0, 2, 3, 8, 10, 19, 20, 21]) expect(at(bytes, place)).toEqual([]);
  });

  test('nothing where a byte is missing, or is beyond the end given', () => {
    const bytes = Uint8Array.from(READ);
    for (let length = 0; length < bytes.length; length++) {
      expect(at(bytes.subarray(0, length))).toEqual([]);
      expect(at(bytes, 0, length)).toEqual([]);
    }
    expect(at(bytes, 0, 8)).toEqual(['rtu request 0-8']);
  });

  test('nothing where one bit is wrong', () => {
    for (let bit = 0; bit < 8 * READ.length; bit++) {
      const bytes = Uint8Array.from(READ);
      bytes[bit >> 3] = (bytes[bit >> 3] as number) ^ (1 << (bit & 7));
      expect(at(bytes)).toEqual([]);
    }
  });

  test('a zero residue is not a longer frame', () => {
    for (const after of [[0x00], [0x00, 0x00], zeros(300)]) {
      expect(at(Uint8Array.of(...READ, ...after))).toEqual(['rtu request 0-8']);
      expect(at(Uint8Array.of(...READ_REPLY, ...after))).toEqual(['rtu response 0-11']);
    }
  });

  test('a reply that ends in 00 is also the request that ends before it: both are said', () => {
    // Four bytes of coils with the CRC 00FF, and a reply of 07 with the CRC 0082: without the 00 no residue is left either.
    const coils = hex('01 01 04 12 34 00 8B FF 00');
    expect(at(coils)).toEqual(['rtu request 0-8 illegal', 'rtu response 0-9']);
    expect(at(coils, 0, 8)).toEqual(['rtu request 0-8 illegal']);
    expect(at(hex('03 07 40 82 00'))).toEqual(['rtu request 0-4', 'rtu response 0-5']);
  });

  test('legal is what breaks no rule', () => {
    // 125 and 126 registers; FF00 and FF01 for a coil; a byte count of 3 for registers; FC 14 with a byte too many
    expect(at(asRtu(1, [0x03, 0, 0, 0, 125]))).toEqual(['rtu request 0-8']);
    expect(at(asRtu(1, [0x03, 0, 0, 0, 126]))).toEqual(['rtu request 0-8 illegal']);
    expect(at(asRtu(1, [0x05, 0, 1, 0xff, 0x00]))).toEqual(['rtu request 0-8', 'rtu response 0-8']);
    expect(at(asRtu(1, [0x05, 0, 1, 0xff, 0x01]))).toEqual(['rtu request 0-8 illegal', 'rtu response 0-8 illegal']);
    expect(at(asRtu(1, [0x03, 3, 1, 2, 3]))).toContain('rtu response 0-8 illegal');
    expect(at(asRtu(1, [0x14, 8, 6, 0, 1, 0, 2, 0, 3, 9]))).toContain('rtu request 0-13 illegal');
  });

  test('a list of groups by their number, and a choice by sub-function and MEI type', () => {
    expect(at(asRtu(1, [0x2b, 0x0e, 1, 0]))).toContain('rtu request 0-7');
    // one object of two characters
    const reply = asRtu(1, [0x2b, 0x0e, 1, 1, 0, 0, 1, 0, 2, 0x41, 0x42]);
    expect(at(Uint8Array.of(...reply, 9, 9))).toEqual(['rtu response 0-14']);
    expect(at(Uint8Array.of(...asRtu(1, [0x08, 0, 0x0b, 0, 0]), 9))).toEqual(['rtu request 0-8', 'rtu response 0-8']);
    expect(at(Uint8Array.of(...asRtu(1, [0x08, 0, 0x0b, 0, 7]), 9))).toEqual([
      'rtu request 0-8 illegal',
      'rtu response 0-8',
    ]);
  });

  test('a function whose length no byte tells ends with the bytes', () => {
    const open = asRtu(1, [0x41, 1, 2, 3]);
    expect(at(open)).toEqual(['rtu request 0-7 open', 'rtu response 0-7 open']);
    expect(at(Uint8Array.of(...open, 9))).toEqual([]);
    expect(at(Uint8Array.of(...open, 9), 0, 7)).toEqual(['rtu request 0-7 open', 'rtu response 0-7 open']);
    expect(at(asRtu(1, [0x2b, 0x0d, 1, 2, 3]))).toEqual(['rtu request 0-8 open', 'rtu response 0-8 open']);
  });

  test('08 sub-function 00 ends with the bytes, or with the one word it usually has', () => {
    const usual = asRtu(1, [0x08, 0, 0, 0xa5, 0x37]);
    const both = ['rtu request 0-8 open', 'rtu response 0-8 open'];
    expect(at(usual)).toEqual(both);
    expect(at(Uint8Array.of(...usual, 9, 9))).toEqual(both);
    expect(at(Uint8Array.of(...usual, ...new Array<number>(300).fill(9)))).toEqual(both);
    expect(at(asRtu(1, [0x08, 0, 0, 1, 2, 3, 4]))).toEqual(['rtu request 0-10 open', 'rtu response 0-10 open']);
  });

  test('at most 256 bytes', () => {
    const longest = asRtu(1, [0x11, 251, ...zeros(251)]);
    expect(at(longest)).toEqual(['rtu response 0-256']);
    expect(at(asRtu(1, [0x11, 252, ...zeros(252)]))).toEqual([]);
    expect(at(asRtu(1, [0x41, ...zeros(252)]))).toEqual(['rtu request 0-256 open', 'rtu response 0-256 open']);
    expect(at(asRtu(1, [0x41, ...zeros(253)]))).toEqual([]);
  });
});

describe('TCP', () => {
  const request = asTcp(0xff, [0x03, 0, 4, 0, 1], 0x1501);

  test('a request, a reply, an exception, an echo, an open function', () => {
    expect(Array.from(request)).toEqual([0x15, 0x01, 0, 0, 0, 6, 0xff, 0x03, 0, 4, 0, 1]);
    expect(at(request)).toEqual(['tcp request 0-12']);
    expect(at(asTcp(1, [0x03, 2, 0, 5]))).toEqual(['tcp response 0-11']);
    expect(at(asTcp(1, [0x83, 2]))).toContain('tcp response 0-9');
    expect(at(asTcp(1, [0x06, 0, 1, 0, 3]))).toEqual(['tcp request 0-12', 'tcp response 0-12']);
    expect(at(Uint8Array.of(...asTcp(1, [0x41, 1, 2]), 7))).toEqual([
      'tcp request 0-10 open',
      'tcp response 0-10 open',
    ]);
  });

  test('nothing where it is cut, or where length or protocol say otherwise', () => {
    for (let length = 0; length < request.length; length++) expect(at(request.subarray(0, length))).toEqual([]);
    for (const place of [2, 3, 4]) expect(at(request.with(place, 1))).toEqual([]);
    for (const length of [0, 1, 2, 5, 7]) expect(at(Uint8Array.of(...request.with(5, length), 0))).toEqual([]);
  });
});

describe('ASCII', () => {
  const request = characters(':010300000001FB\r\n');

  test('a request, a reply, an exception, an echo, a lone LF, another delimiter, lower case', () => {
    expect(at(request)).toEqual(['ascii request 0-17']);
    expect(at(asAscii(0x11, [0x01, 2, 0xcd, 0x6b]))).toEqual(['ascii response 0-15']);
    expect(at(asAscii(0x11, [0x81, 1]))).toContain('ascii response 0-11');
    expect(at(asAscii(0x11, [0x06, 0, 1, 0, 3]))).toEqual(['ascii request 0-17', 'ascii response 0-17']);
    expect(at(characters(':010300000001FB\n'))).toContain('ascii request 0-16 illegal');
    expect(at(characters(':010300000001FB\r;'))).toEqual(['ascii request 0-17']);
    expect(at(characters(':010300000001fb\r\n'))).toEqual(['ascii request 0-17']);
  });

  test('it ends with its end, whatever follows', () => {
    expect(at(characters('x:010300000001FB\r\n:01'), 1)).toEqual(['ascii request 1-18']);
  });

  test('nothing where it is cut, a digit is wrong, is none, or is missing, or a field is too short', () => {
    for (let length = 0; length < request.length; length++) expect(at(request.subarray(0, length))).toEqual([]);
    for (const text of ['010300000001FA', '010300000001F', '0103 00000001FB', '01030000000000FC', '0103000001FB']) {
      expect(at(characters(`:${text}\r\n`))).toEqual([]);
    }
  });
});

test('only the transport asked for', () => {
  // An RTU request to unit 0 whose bytes are an MBAP as well.
  const bytes = Uint8Array.from(READ);
  expect(framesAt(bytes, 0, 8, 'rtu')).toHaveLength(1);
  expect(framesAt(bytes, 0, 8, 'tcp')).toEqual([]);
  expect(framesAt(bytes, 0, 8, 'ascii')).toEqual([]);
});

test.each(frames.filter(({ transport }) => transport !== 'pdu'))('$id stands at its place', (frame) => {
  const bytes = hex(frame.hex);
  const found = framesAt(Uint8Array.of(0xff, ...bytes, 0xff), 1, 1 + bytes.length);
  const own = found.filter(
    ({ transport, direction }) => transport === frame.transport && direction === frame.direction,
  );
  expect(own.at(-1)).toMatchObject({ from: 1, to: 1 + bytes.length, legal: true });
});

test('any bytes: never throws, and says only frames within its bounds', () => {
  fc.assert(
    fc.property(anyBytes, fc.nat(300), fc.nat(300), (bytes, place, end) => {
      for (const { from, to } of framesAt(bytes, place, Math.min(end, bytes.length))) {
        if (from !== place || to > end || to <= from) expect.unreachable(`[${from}, ${to})`);
      }
    }),
    { numRuns: 2000 },
  );
});
