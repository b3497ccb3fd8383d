import { describe, expect, it } from 'vitest';
import { diagnose } from '../../../src/diagnosis/index.ts';
import { characters, hex } from '../modbus/frames.ts';
import { findingsOf, firstOf, type Known, repairsOf, spaced } from './findings.ts';

const REQUEST = '11 03 00 6B 00 03 76 87';
const REPLY = '11 03 06 AE 41 56 52 43 40 49 AD';
const rtu = { transport: 'rtu' } as const;
const asked = { ...rtu, request: REQUEST };

interface Example {
  readonly what: string;
  readonly bytes: string;
  readonly known?: Known;
  readonly found: object;
  readonly repaired?: readonly string[];
}

const examples: readonly Example[] = [
  { what: 'the request came back', bytes: REQUEST, known: asked, found: { code: 'echo', wrong: 0, rest: 0 } },
  {
    what: 'the request, and behind it the reply',
    bytes: `${REQUEST} ${REPLY}`,
    known: asked,
    found: { code: 'echo', rest: 11 },
    repaired: [REPLY],
  },
  {
    what: 'the beginning of the request',
    bytes: '11 03 00 6B 00 03',
    known: asked,
    found: { code: 'truncated-echo', missing: 2, wrong: 0 },
  },
  {
    what: 'the reply to a write is its beginning, not its echo',
    bytes: '01 10 00 01 00 02',
    known: { ...rtu, request: '01 10 00 01 00 02 04 00 0A 01 02 92 30' },
    found: { code: 'crc-missing' },
    repaired: ['01 10 00 01 00 02 10 08'],
  },
  {
    what: 'the reply to a single write is the request’s bytes',
    bytes: '01 06 00 01 00 03 98 0B',
    known: { ...rtu, request: '01 06 00 01 00 03 98 0B' },
    found: { code: 'valid', directions: ['request', 'response'] },
  },
  {
    what: 'a byte in front',
    bytes: `00 ${REPLY}`,
    found: { code: 'stray-leading', leading: 1, previous: false, from: 0, to: 1 },
    repaired: [REPLY],
  },
  {
    what: 'the last byte of the frame before in front',
    bytes: `AD ${REPLY}`,
    found: { code: 'stray-leading', leading: 1, previous: true },
    repaired: [REPLY],
  },
  {
    what: 'the last byte of the request in front',
    bytes: `87 ${REPLY}`,
    known: asked,
    found: { code: 'stray-leading', leading: 1, previous: true },
    repaired: [REPLY],
  },
  {
    what: 'a byte behind',
    bytes: `${REPLY} FF`,
    found: { code: 'stray-trailing', trailing: 1, zero: false, from: 11, to: 12 },
    repaired: [REPLY],
  },
  {
    what: 'a zero behind, with which the CRC holds too',
    bytes: '01 83 02 C0 F1 00',
    found: { code: 'stray-trailing', trailing: 1, zero: true },
    repaired: ['01 83 02 C0 F1'],
  },
  {
    what: 'bytes around',
    bytes: `00 ${REPLY} 00 FF`,
    found: { code: 'stray-around', leading: 1, trailing: 2 },
    repaired: [REPLY],
  },
  {
    what: 'a byte in front and the last one lost',
    bytes: `1D ${REPLY.slice(0, -3)}`,
    found: { code: 'stray-leading+truncated', leading: 1, missing: 1 },
    repaired: [REPLY],
  },
  {
    what: 'the last byte lost',
    bytes: REPLY.slice(0, -3),
    found: { code: 'truncated', missing: 1, has: 10 },
    repaired: [REPLY],
  },
  { what: 'the byte count promises more', bytes: '11 03 06 AE 41', found: { code: 'truncated', missing: 6, has: 5 } },
  {
    what: 'a TCP frame shorter than its length says',
    bytes: '00 01 00 00 00 09 11 03 06 AE 41 56',
    known: { transport: 'tcp' },
    found: { code: 'truncated', missing: 3, has: 12 },
  },
  {
    what: 'an ASCII frame without its end',
    bytes: ':1103006B00',
    known: { transport: 'ascii' },
    found: { code: 'truncated', has: 11 },
  },
  {
    what: 'request and reply in one',
    bytes: `${REQUEST} ${REPLY}`,
    found: { code: 'merged', frames: 2, between: 0 },
    repaired: [REQUEST, REPLY],
  },
  {
    what: 'three frames and a byte of none',
    bytes: `${REQUEST} FF ${REPLY} 01 83 02 C0 F1`,
    found: { code: 'merged', frames: 3, between: 1 },
    repaired: [REQUEST, REPLY, '01 83 02 C0 F1'],
  },
  {
    what: 'two TCP frames in one',
    bytes: '00 01 00 00 00 06 11 03 00 6B 00 03 00 02 00 00 00 06 11 03 00 6E 00 03',
    known: { transport: 'tcp' },
    found: { code: 'merged', frames: 2 },
  },
  {
    what: 'turned by three bytes',
    bytes: '40 49 AD 11 03 06 AE 41 56 52 43',
    found: { code: 'rotated', by: 3 },
    repaired: [REPLY],
  },
  {
    what: 'a byte count too small, and a CRC that holds',
    bytes: '11 03 04 AE 41 56 52 43 40 6A 6D',
    found: { code: 'byte-count', got: 4, expected: 6, from: 2, to: 3 },
    repaired: [REPLY],
  },
  {
    what: 'no byte count, and a CRC taken without it',
    bytes: '11 03 AE 41 56 52 43 40 16 D3',
    found: { code: 'byte-count', got: undefined, expected: 6 },
    repaired: [REPLY],
  },
  {
    what: 'no byte count, and the CRC of the frame with it',
    bytes: '11 03 AE 41 56 52 43 40 49 AD',
    found: { code: 'byte-count', got: undefined, expected: 6 },
    repaired: [REPLY],
  },
  {
    what: 'bytes inside that no field takes',
    bytes: '00 01 00 00 00 08 11 06 00 01 00 03 AA BB',
    known: { transport: 'tcp' },
    found: { code: 'extra-bytes', bytes: 2, from: 12, to: 14 },
    repaired: ['00 01 00 00 00 06 11 06 00 01 00 03'],
  },
  {
    what: 'bytes behind a bare PDU',
    bytes: '03 00 6B 00 03 02',
    known: { transport: 'pdu' },
    found: { code: 'extra-bytes', bytes: 1, from: 5, to: 6 },
    repaired: ['03 00 6B 00 03'],
  },
  {
    what: 'a write that counts registers instead of bytes',
    bytes: '01 10 00 01 00 02 02 00 0A 01 02 1A 30',
    found: { code: 'byte-count', got: 2, expected: 4 },
    repaired: ['01 10 00 01 00 02 04 00 0A 01 02 92 30'],
  },
  {
    what: 'characters in front of an ASCII frame',
    bytes: spaced(characters('xx:1103006B00037E\r\n')),
    known: { transport: 'ascii' },
    found: { code: 'stray-leading', leading: 2 },
    repaired: [spaced(characters(':1103006B00037E\r\n'))],
  },
  {
    what: 'digits with blanks as characters',
    bytes: spaced(characters('11 03 00 6B 00 03 76 87')),
    found: { code: 'hex-of-ascii-frame', text: '11 03 00 6B 00 03 76 87' },
    repaired: [REQUEST],
  },
  {
    what: 'a length that is one too large',
    bytes: '00 01 00 00 00 07 11 03 00 6B 00 03',
    known: { transport: 'tcp' },
    found: { code: 'mbap-length', got: 7, expected: 6, swapped: false, from: 4, to: 6 },
    repaired: ['00 01 00 00 00 06 11 03 00 6B 00 03'],
  },
  {
    what: 'a length with its bytes swapped',
    bytes: '00 01 00 00 06 00 11 03 00 6B 00 03',
    known: { transport: 'tcp' },
    found: { code: 'mbap-length', got: 0x600, expected: 6, swapped: true },
  },
  {
    what: 'an ASCII frame that ends with LF alone',
    bytes: ':1103006B00037E\n',
    known: { transport: 'ascii' },
    found: { code: 'ascii-line-end', got: '0A' },
    repaired: [spaced(characters(':1103006B00037E\r\n'))],
  },
  {
    what: 'an ASCII frame on an RTU line',
    bytes: ':1103006B00037E\r\n',
    known: rtu,
    found: { code: 'hex-of-ascii-frame', inMbap: false },
    repaired: [REQUEST],
  },
  {
    what: 'the digits of an RTU frame as characters',
    bytes: spaced(characters('1103006B00037687')),
    known: rtu,
    found: { code: 'hex-of-ascii-frame', text: '1103006B00037687' },
    repaired: [REQUEST],
  },
  { what: 'a line that lies still', bytes: '00 00 00 00 00 00', found: { code: 'noise', pattern: 'constant' } },
  {
    what: 'ones and zeros exchanged',
    bytes: 'EE FC FF 94 FF FC 89 78',
    found: { code: 'noise', pattern: 'polarity' },
    repaired: [REQUEST],
  },
  {
    what: 'the highest bit first',
    bytes: '88 C0 00 D6 00 C0 6E E1',
    found: { code: 'noise', pattern: 'bit-order' },
    repaired: [REQUEST],
  },
  {
    what: 'seven bits and even parity as eight bits',
    // :1103006B00037E with the parity of each character in its highest bit.
    bytes: '3A B1 B1 30 33 30 30 36 42 30 30 30 33 B7 C5 8D 0A',
    known: { transport: 'ascii' },
    found: { code: 'noise', pattern: 'parity' },
    repaired: [spaced(characters(':1103006B00037E\r\n'))],
  },
  {
    what: 'every bit seen twice',
    // 11 begins 0 1000 1000 1: start, then 1 0 0 0 …, each in two samples.
    bytes: '06 18 66 98 7E 80 1E E0 06',
    found: { code: 'noise', pattern: 'too-fast', times: 2 },
  },
  { what: 'garbage', bytes: 'E5 F3 D9 E9 FE F3 D9 4D', known: rtu, found: { code: 'noise', pattern: 'unknown' } },
];

describe('where frames begin and end', () => {
  it.each(examples.map((example) => [example.what, example] as const))(
    '%s',
    (_, { bytes, known = rtu, found, repaired }) => {
      const first = firstOf(bytes, known);
      expect(first).toMatchObject(found);
      if (repaired) expect(repairsOf(first)).toEqual(repaired);
    },
  );
});

describe('pieces of one frame', () => {
  const pieces = ['11 03 06 AE', '41 56 52', '43 40 49 AD'].map(hex);

  it.each([0, 1, 2])('piece %i of three', (i) => {
    const [found] = diagnose(pieces[i]!, { preceding: pieces.slice(0, i), following: pieces.slice(i + 1) });
    expect(found).toMatchObject({ code: 'fragments', lines: 3 });
    expect(found!.repaired.map(spaced)).toEqual([REPLY]);
  });

  it('takes only the pieces that belong to it', () => {
    const [found] = diagnose(pieces[1]!, {
      preceding: [hex(REQUEST), pieces[0]!],
      following: [pieces[2]!, hex(REQUEST)],
    });
    expect(found).toMatchObject({ code: 'fragments', lines: 3 });
  });
});

describe('what chance alone makes', () => {
  it('is not offered as a repair', () => {
    // Sixty bytes of a random generator, in which no frame is.
    const bytes =
      '9C 51 E3 0B 7A 44 D8 2F 66 B1 09 FE 83 5D 20 C7 3E 98 A5 12 EB 74 4F D0 6C 1A B9 57 E2 03 ' +
      '8D F8 35 40 CA 91 7E 26 DD 5B 08 B4 63 EF 1C A7 72 39 C0 85 4E 2A F1 9B 60 D7 14 AC 5F 31';
    expect(findingsOf(bytes)).toEqual([
      { code: 'noise', confidence: 'possible', from: 0, to: 60, pattern: 'unknown', times: undefined, repaired: [] },
    ]);
  });

  it('finds nothing in nothing', () => {
    expect(findingsOf('')).toEqual([]);
  });
});
