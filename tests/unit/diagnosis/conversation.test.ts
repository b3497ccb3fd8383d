import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { type ConversationChunk, type ConversationItem, readConversation } from '../../../src/diagnosis/index.ts';
import type { Direction } from '../../../src/modbus/index.ts';
import { anyBytes } from '../modbus/arbitraries.ts';
import { characters, hex } from '../modbus/frames.ts';

/** `rtu response 8-33 of 0`, with the worst that is wrong behind it. */
const say = (item: ConversationItem): string => {
  const { kind, from, to } = item;
  if (kind === 'unread') return `unread ${from}-${to}`;
  const { transport, direction, answers, severity } = item;
  const of = answers === undefined ? '' : ` of ${answers}`;
  return `${transport} ${direction} ${from}-${to}${of}${severity === undefined ? '' : ` ${severity}`}`;
};

type Line = string | Uint8Array | { readonly hex: string | Uint8Array; readonly direction: Direction };

/** Lines, one behind the other: hexadecimal pairs, with their direction where it is known. */
function read(...lines: readonly Line[]): string[] {
  const all: number[] = [];
  const chunks: ConversationChunk[] = [];
  for (const line of lines) {
    const text = typeof line === 'object' && 'hex' in line ? line.hex : line;
    const bytes = typeof text === 'string' ? hex(text) : text;
    const direction = typeof line === 'object' && 'direction' in line ? line.direction : undefined;
    chunks.push({ from: all.length, to: all.length + bytes.length, direction });
    all.push(...bytes);
  }
  return readConversation(Uint8Array.from(all), chunks).map(say);
}

const asked = (text: string): Line => ({ hex: text, direction: 'request' });
const answered = (text: string): Line => ({ hex: text, direction: 'response' });

/** Ten registers from 384 of unit 1. */
const READ = '01 03 01 80 00 0A C5 D9';
const REGISTERS = '01 03 14 00 95 00 97 00 E1 00 E1 00 00 00 C8 03 26 00 00 03 25 03 26 A1 B5';
const WRITE = '11 06 00 01 00 03 9A 9B';

describe('one frame a line', () => {
  test('a request and its reply', () => {
    expect(read(READ, REGISTERS)).toEqual(['rtu request 0-8', 'rtu response 8-33 of 0']);
  });

  test('writes alternate with the replies that echo them', () => {
    expect(read(WRITE, WRITE, WRITE, WRITE)).toEqual([
      'rtu request 0-8',
      'rtu response 8-16 of 0',
      'rtu request 16-24',
      'rtu response 24-32 of 2',
    ]);
  });

  test('a reply whose request is not here answers none', () => {
    expect(read(REGISTERS, READ, REGISTERS)).toEqual([
      'rtu response 0-25',
      'rtu request 25-33',
      'rtu response 33-58 of 1',
    ]);
  });

  test('a request that is repeated is answered once', () => {
    expect(read(READ, READ, REGISTERS)).toEqual(['rtu request 0-8', 'rtu request 8-16', 'rtu response 16-41 of 1']);
  });

  test('nobody answers a broadcast', () => {
    const broadcast = '00 06 00 01 00 03 99 DA';
    expect(read(broadcast, broadcast)).toEqual(['rtu request 0-8', 'rtu request 8-16']);
  });

  test('transactions on TCP that are open side by side', () => {
    const items = read(
      '00 01 00 00 00 06 01 03 00 00 00 01',
      '00 02 00 00 00 06 01 03 00 05 00 02',
      '00 02 00 00 00 07 01 03 04 00 01 00 02',
      '00 01 00 00 00 05 01 03 02 00 07',
    );
    expect(items).toEqual([
      'tcp request 0-12',
      'tcp request 12-24',
      'tcp response 24-37 of 1',
      'tcp response 37-48 of 0',
    ]);
  });

  test('ASCII, with and without its line ends', () => {
    const ends = [characters(':010300000001FB\r\n'), characters(':01030200FFFB\r\n')];
    expect(read(...ends)).toEqual(['ascii request 0-17', 'ascii response 17-32 of 0']);
    const none = [characters(':010300000001FB'), characters(':01030200FFFB')];
    expect(read(...none)).toEqual(['ascii request 0-15', 'ascii response 15-28 of 0']);
  });

  test('bare PDUs', () => {
    expect(read('03 00 00 00 02', '03 04 00 01 00 02')).toEqual(['pdu request 0-5', 'pdu response 5-11 of 0']);
  });
});

describe('replies are checked against their requests', () => {
  test('another unit', () => {
    expect(read(asked('01 06 40 03 00 17 2C 04'), answered('17 06 40 03 00 17 2E F2'))).toEqual([
      'rtu request 0-8',
      'rtu response 8-16 of 0 error',
    ]);
  });

  test('an exception, to the function and to another', () => {
    expect(read('01 03 00 00 00 04 44 09', '01 83 02 C0 F1')).toEqual(['rtu request 0-8', 'rtu response 8-13 of 0']);
    expect(read('01 03 00 00 00 04 44 09', '01 90 02 CD C1')).toEqual([
      'rtu request 0-8',
      'rtu response 8-13 of 0 error',
    ]);
  });

  test('fewer registers than were asked for', () => {
    expect(read(READ, '01 03 02 00 00 B8 44')).toEqual(['rtu request 0-8', 'rtu response 8-15 of 0 error']);
  });

  test('another transaction identifier', () => {
    expect(read('00 01 00 00 00 06 01 03 00 00 00 01', '01 00 00 00 00 05 01 03 02 00 07')).toEqual([
      'tcp request 0-12',
      'tcp response 12-23 of 0 error',
    ]);
  });

  test('a reply of another unit and another function answers something else', () => {
    expect(read(READ, '11 01 05 CD 6B B2 0E 1B 45 E6')).toEqual(['rtu request 0-8', 'rtu response 8-18']);
  });
});

describe('directions that the text says', () => {
  test('decide where the bytes do not', () => {
    expect(read(answered(WRITE), asked(WRITE), asked(WRITE))).toEqual([
      'rtu response 0-8',
      'rtu request 8-16',
      'rtu request 16-24',
    ]);
  });

  test('do not where they are impossible: an echo of the request', () => {
    expect(read(asked(READ), answered(READ), answered(REGISTERS))).toEqual([
      'rtu request 0-8',
      'rtu request 8-16',
      'rtu response 16-41 of 1',
    ]);
  });

  test('are turned in the log of a server, which receives requests', () => {
    expect(read(answered(WRITE), asked(WRITE), answered(READ), asked(REGISTERS))).toEqual([
      'rtu request 0-8',
      'rtu response 8-16 of 0',
      'rtu request 16-24',
      'rtu response 24-49 of 2',
    ]);
  });
});

describe('lines that are not one frame', () => {
  test('several frames in one', () => {
    expect(read(`${READ} ${REGISTERS} ${WRITE} ${WRITE}`)).toEqual([
      'rtu request 0-8',
      'rtu response 8-33 of 0',
      'rtu request 33-41',
      'rtu response 41-49 of 2',
    ]);
  });

  test('a frame of one byte a line', () => {
    expect(read(...READ.split(' '), REGISTERS)).toEqual(['rtu request 0-8', 'rtu response 8-33 of 0']);
  });

  test('a reply in three parts', () => {
    expect(read(READ, REGISTERS.slice(0, 30), REGISTERS.slice(30, 60), REGISTERS.slice(60), READ)).toEqual([
      'rtu request 0-8',
      'rtu response 8-33 of 0',
      'rtu request 33-41',
    ]);
  });

  test('parts of different directions are not one frame', () => {
    const [head, tail] = [REGISTERS.slice(0, 30), REGISTERS.slice(30)];
    expect(read(asked(READ), asked(head), answered(tail))).toEqual([
      'rtu request 0-8',
      'rtu response 8-18 of 0 error',
      'unread 18-33',
    ]);
  });

  test('stray bytes around a frame stay with it', () => {
    expect(read('04 03 01 21 00 01 D5 A9', '00 04 83 02 D0 F0 00')).toEqual([
      'rtu request 0-8',
      'rtu response 8-15 of 0 error',
    ]);
  });

  test('a stray byte on a line of its own', () => {
    expect(read(asked(WRITE), answered('FF'), answered(WRITE))).toEqual([
      'rtu request 0-8',
      'unread 8-9',
      'rtu response 9-17 of 0',
    ]);
  });

  test('noise is left as it is', () => {
    expect(read(READ, 'E5 F3 D9 E9 FE F3 D9 4D', REGISTERS)).toEqual([
      'rtu request 0-8',
      'unread 8-16',
      'rtu response 16-41 of 0',
    ]);
  });
});

describe('broken frames', () => {
  test('a wrong CRC, as request and as reply', () => {
    expect(read('01 03 01 80 00 0A C5 D8', REGISTERS)).toEqual(['rtu request 0-8 error', 'rtu response 8-33 of 0']);
    expect(read(READ, REGISTERS.replace('B5', 'B4'))).toEqual(['rtu request 0-8', 'rtu response 8-33 of 0 error']);
  });

  test('a damaged request is answered by what would have echoed it', () => {
    expect(read('11 06 00 01 00 02 9A 9B', WRITE)).toEqual(['rtu request 0-8 error', 'rtu response 8-16 of 0 error']);
  });

  test('a reply with another count, but as long as it should be', () => {
    // 20 bytes are counted as 4, or as 148: two registers of another reply, or a frame that is cut off.
    for (const count of ['04', '94', '00'])
      expect(read(READ, REGISTERS.replace('14', count))).toEqual(['rtu request 0-8', 'rtu response 8-33 of 0 error']);
  });

  test('a reply that is cut off', () => {
    expect(read('0B 03 40 00 00 20 51 78', '0B 03 40 45 CE 0B D7 00 00 00')).toEqual([
      'rtu request 0-8',
      'rtu response 8-18 of 0 error',
    ]);
    expect(read('01 03 3E 00 71 02 7B')).toEqual(['rtu response 0-7 error']);
  });

  test('of one byte a line', () => {
    expect(read('F7 03 50 0A 00 05 A0 5D', 'F7', '03', '4A', '5D', 'DA')).toEqual([
      'rtu request 0-8',
      'rtu response 8-13 of 0 error',
    ]);
    expect(read(...'01 03 00 29 00 01 83 01'.split(' '))).toEqual(['rtu request 0-8 error']);
    expect(read(READ, 'FF', REGISTERS, '01', '83', 'FF FF')).toEqual([
      'rtu request 0-8',
      'unread 8-9',
      'rtu response 9-34 of 0',
      'rtu response 34-38 error',
    ]);
  });

  test('only broken ones', () => {
    expect(read('01 03 00 29 00 01 83 01')).toEqual(['rtu request 0-8 error']);
    expect(read('18 58 00 00 00 04 01 83 03')).toEqual(['tcp response 0-9 error']);
    expect(read(characters(':010300000001FC'))).toEqual(['ascii request 0-15 error']);
  });

  test('as the transport of the others, though they might be another', () => {
    // By itself three registers of a bare PDU.
    expect(read(READ, REGISTERS, '03 06 DE AD BE EF 12 34')).toEqual([
      'rtu request 0-8',
      'rtu response 8-33 of 0',
      'rtu request 33-41 error',
    ]);
  });
});

/** Requests and their replies. */
const PAIRS = [
  [READ, REGISTERS],
  [WRITE, WRITE],
  ['01 03 00 00 00 04 44 09', '01 83 02 C0 F1'],
  ['11 10 00 01 00 02 04 00 0A 01 02 C6 F0', '11 10 00 01 00 02 12 98'],
  ['11 01 00 13 00 25 0E 84', '11 01 05 CD 6B B2 0E 1B 45 E6'],
] as const;

test('the bytes of a frame without its checksum, and the frame behind them, are not a request and its reply', () => {
  // A guide puts a frame together: first without its CRC, then with it.
  expect(read('06 06 02 AB 10 00', '06 06 02 AB 10 00 F5 E5')).toEqual(['rtu request 0-6 error', 'rtu request 6-14']);
  expect(read('06 06 02 AB 10 00', '06 06 02 AB 10 00 F5 E5', '06 06 02 AB 10 00 F5 E5')).toEqual([
    'rtu request 0-6 error',
    'rtu request 6-14',
    'rtu response 14-22 of 1',
  ]);
  // What the text says decides.
  expect(read(asked('06 06 02 AB 10 00'), answered('06 06 02 AB 10 00 F5 E5'))).toEqual([
    'rtu request 0-6 error',
    'rtu response 6-14 of 0',
  ]);
});

describe('any traffic', () => {
  const anyPairs = fc.array(fc.constantFrom(...PAIRS), { minLength: 1, maxLength: 12 });

  /** What is read of frames end to end if none is missed, and each reply answers the request before it. */
  function expected(frames: readonly string[]): string[] {
    let at = 0;
    return frames.map((frame, i) => {
      const from = at;
      at += hex(frame).length;
      return i % 2 === 0 ? `rtu request ${from}-${at}` : `rtu response ${from}-${at} of ${i - 1}`;
    });
  }

  test('a frame a line', () => {
    fc.assert(
      fc.property(anyPairs, (pairs) => {
        expect(read(...pairs.flat())).toEqual(expected(pairs.flat()));
      }),
    );
  });

  test('with frames cut over lines', () => {
    const anyCuts = fc.array(fc.tuple(fc.boolean(), fc.nat(), fc.nat()), { minLength: 24, maxLength: 24 });
    fc.assert(
      fc.property(anyPairs, anyCuts, (pairs, cuts) => {
        const lines = pairs.flat().flatMap((frame, i) => {
          const bytes = hex(frame);
          const [isCut = false, first = 0, second = 0] = cuts[i] ?? [];
          if (!isCut) return [bytes];
          const [a = 0, b = 0] = [first, second].map((cut) => 1 + (cut % (bytes.length - 1))).sort((x, y) => x - y);
          return [bytes.subarray(0, a), bytes.subarray(a, b), bytes.subarray(b)].filter(({ length }) => length > 0);
        });
        expect(read(...lines)).toEqual(expected(pairs.flat()));
      }),
    );
  });

  test('with a line of noise somewhere', () => {
    const noise = 'E5 F3 D9 E9 FE F3 D9 4D';
    fc.assert(
      fc.property(anyPairs, fc.nat(), (pairs, place) => {
        const frames: string[] = pairs.flat();
        const at = place % (frames.length + 1);
        const found = read(...frames.slice(0, at), noise, ...frames.slice(at));
        expect(found[at]).toMatch(/^unread/);
        expect(found.filter((item) => item.startsWith('rtu request')).length).toBe(pairs.length);
        expect(found.filter((item) => / of \d+$/.test(item)).length).toBe(pairs.length);
      }),
    );
  });
});

describe('one transport', () => {
  // Its bytes are those of an MBAP with length 2 as well.
  const wrong = '01 03 00 00 00 02 C4 0A';

  test('a serial request for two registers from 0 with a wrong CRC', () => {
    expect(read(READ, REGISTERS, wrong)).toEqual([
      'rtu request 0-8',
      'rtu response 8-33 of 0',
      'rtu request 33-41 error',
    ]);
    expect(read(wrong)).toEqual(['rtu request 0-8 error']);
    expect(read(READ, REGISTERS, `FF ${wrong}`)[2]).not.toMatch(/^tcp/);
  });

  test('a TCP request that is as short', () => {
    expect(read('00 01 00 00 00 02 01 11')).toEqual(['tcp request 0-8 note']);
  });

  test('lines of several transports', () => {
    expect(read(READ, '00 01 00 00 00 06 01 03 00 00 00 01', REGISTERS)).toEqual([
      'rtu request 0-8',
      'tcp request 8-20',
      'rtu response 20-45 of 0',
    ]);
  });
});

describe('any chunks', () => {
  const anyChunks = fc.array(
    fc.record(
      {
        from: fc.integer({ min: -3, max: 60 }),
        to: fc.integer({ min: -3, max: 60 }),
        direction: fc.constantFrom('request' as const, 'response' as const, undefined),
        transport: fc.constantFrom('rtu' as const, 'ascii' as const, 'tcp' as const, 'pdu' as const, undefined),
      },
      { requiredKeys: ['from', 'to'] },
    ),
  );

  test('give items in order that do not overlap, with replies behind their requests', () => {
    fc.assert(
      fc.property(anyBytes, anyChunks, (bytes, chunks) => {
        const items = readConversation(bytes, chunks);
        let at = 0;
        for (const [i, item] of items.entries()) {
          expect(item.from).toBeGreaterThanOrEqual(at);
          expect(item.to).toBeGreaterThan(item.from);
          at = item.to;
          if (item.kind === 'frame' && item.answers !== undefined) {
            expect(item.answers).toBeLessThan(i);
            expect(items[item.answers]).toMatchObject({ kind: 'frame', direction: 'request' });
          }
        }
        expect(at).toBeLessThanOrEqual(bytes.length);
      }),
      { numRuns: 500 },
    );
  });

  test('of any number of frames', () => {
    const request = hex('01 07 41 E2');
    const bytes = Uint8Array.from({ length: 520_000 }, (_, i) => request[i % 4] as number);
    expect(readConversation(bytes, [{ from: 0, to: bytes.length }])).toHaveLength(130_000);
  });

  test('that cover the bytes give items that cover them, each once', () => {
    fc.assert(
      fc.property(fc.array(anyBytes, { maxLength: 6 }), (lines) => {
        const bytes = Uint8Array.from(lines.flatMap((line) => [...line]));
        let end = 0;
        const chunks = lines.map((line) => {
          const from = end;
          end += line.length;
          return { from, to: end };
        });
        let at = 0;
        for (const { from, to } of readConversation(bytes, chunks)) {
          expect(from).toBe(at);
          at = to;
        }
        expect(at).toBe(bytes.length);
      }),
      { numRuns: 100 },
    );
  });
});

describe('a reply whose MBAP length is wrong', () => {
  const ASKED = '00 01 00 00 00 06 01 03 00 00 00 03';

  test('stays a reply where the text says so, and the one below it answers nothing', () => {
    expect(read(asked(ASKED), answered('00 01 00 00 00 06 01 03 06 01 00 00 00 00 34'))).toEqual([
      'tcp request 0-12',
      'tcp response 12-27 of 0 error',
    ]);
  });

  test.each([
    ['too small by one', '00 01 00 00 00 08 01 03 06 01 00 00 00 00 34'],
    ['too large', '00 01 00 00 00 10 01 03 06 01 00 00 00 00 34'],
    ['that of the request', '00 01 00 00 00 06 01 03 06 01 00 00 00 00 34'],
  ])('stays a reply where only the request before it tells: %s', (_, reply) => {
    expect(read(ASKED, reply)).toEqual(['tcp request 0-12', 'tcp response 12-27 of 0 error']);
  });

  test('two frames in one chunk are no such frame', () => {
    expect(read(`${ASKED} ${ASKED}`)).toEqual(['tcp request 0-12', 'tcp request 12-24']);
  });
});

test('a message of another protocol is no broken frame', () => {
  expect(read('A5 40 90 08 00 00 00 00 00 00 00 00 7D', READ)).toEqual(['unread 0-13', 'rtu request 13-21']);
});
