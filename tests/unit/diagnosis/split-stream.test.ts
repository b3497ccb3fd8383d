import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { type Segment, splitStream } from '../../../src/diagnosis/index.ts';
import { anyBytes } from '../modbus/arbitraries.ts';
import { characters, hex } from '../modbus/frames.ts';
import { asAscii, asRtu, asTcp } from '../modbus/reference.ts';
import { frames } from '../modbus/vectors.ts';
import { userFrames } from './user-frames.ts';

/** `request 0-8`, `gap 8-9`; `either` where no direction is told. */
const say = (segment: Segment) =>
  `${segment.kind === 'gap' ? 'gap' : (segment.direction ?? 'either')} ${segment.from}-${segment.to}`;

const split = (...parts: readonly Iterable<number>[]) =>
  splitStream(Uint8Array.from(parts.flatMap((part) => [...part]))).map(say);

const READ = hex('01 03 01 80 00 0A C5 D9');
const REPLY = hex('11 03 06 AE41 5652 4340 49AD');
/** Register 1 of unit 17 gets 3: request and reply are alike. */
const WRITE = hex('11 06 0001 0003 9A9B');

/** Every byte lies in exactly one segment, in order; no segment is empty and no two gaps adjoin. */
function expectCovered(segments: readonly Segment[], length: number): void {
  let at = 0;
  let before: Segment | undefined;
  for (const segment of segments) {
    if (segment.from !== at || segment.to <= at) expect.unreachable(`${say(segment)} where ${at} comes next`);
    if (segment.kind === 'gap' && before?.kind === 'gap') expect.unreachable(`${say(segment)} behind a gap`);
    at = segment.to;
    before = segment;
  }
  if (at !== length) expect(at).toBe(length);
}

describe('frames end to end', () => {
  test('nothing, one byte, one frame', () => {
    expect(split()).toEqual([]);
    expect(split([0])).toEqual(['gap 0-1']);
    expect(split(READ)).toEqual(['request 0-8']);
    expect(splitStream(READ)).toEqual([{ kind: 'frame', transport: 'rtu', direction: 'request', from: 0, to: 8 }]);
  });

  test('a request and its reply from a dump without any delimiters', () => {
    const { hex: text } = userFrames.find(({ id }) => id === 'user-29')!;
    expect(split(hex(text))).toEqual(['request 0-8', 'response 8-33']);
  });

  test('a zero after a frame is no part of it', () => {
    expect(split(READ, [0], REPLY)).toEqual(['request 0-8', 'gap 8-9', 'response 9-20']);
    expect(split(READ, [0, 0, 0])).toEqual(['request 0-8', 'gap 8-11']);
  });

  test('a reply that ends in 00 is not the request that ends before it', () => {
    // 07 of unit 3, its reply with the CRC 0082, and the next request
    const asked = asRtu(3, [0x07]);
    expect(split(asked, hex('03 07 40 82 00'), READ)).toEqual(['request 0-4', 'response 4-9', 'request 9-17']);
    expect(split(asked, hex('03 07 40 82 00'))).toEqual(['request 0-4', 'response 4-9']);
  });

  test('a reply of eight bytes is told from a request by what was asked', () => {
    // 20 coils are asked for; the three bytes that answer read as address 0312 and quantity 0001 too.
    const asked = asRtu(1, [0x01, 0, 0, 0, 20]);
    const answer = asRtu(1, [0x01, 3, 0x12, 0x00, 0x01]);
    expect(split(asked, answer)).toEqual(['request 0-8', 'response 8-16']);
    expect(split(answer)).toEqual(['either 0-8']);
  });

  test('a chain outweighs what lies across it', () => {
    // The CRC of a longer frame that begins in the reply's registers closes over the request behind it.
    const inner = asRtu(9, [0x03, 4, 0xca, 0xfe, 0xba, 0xbe]);
    const outer = asRtu(1, [0x10, 0, 0, 0, 5, 10, ...inner, 0]);
    expect(split(READ, outer, READ)).toEqual([
      'request 0-8',
      `request 8-${8 + outer.length}`,
      `request ${8 + outer.length}-${16 + outer.length}`,
    ]);
  });
});

describe('damage', () => {
  test('what is damaged is a gap, and the next frame is found', () => {
    const damaged = REPLY.with(5, 0xff);
    expect(split(READ, damaged, READ, REPLY)).toEqual(['request 0-8', 'gap 8-19', 'request 19-27', 'response 27-38']);
    expect(split(READ.subarray(1), REPLY)).toEqual(['gap 0-7', 'response 7-18']);
    expect(split(READ, REPLY.subarray(0, 10))).toEqual(['request 0-8', 'gap 8-18']);
  });

  test('a chance hit that breaks rules is not believed alone, but beside other frames it is', () => {
    const illegal = asRtu(1, [0x03, 0, 0, 0, 126]);
    expect(split([0xff, 0xff], illegal, [0xff, 0xff])).toEqual(['gap 0-12']);
    expect(split(illegal, asRtu(1, [0x83, 3]))).toEqual(['request 0-8', 'response 8-13']);
  });

  test('many times the longest frame of nothing', () => {
    expect(split(new Uint8Array(100_000).fill(3))).toEqual(['gap 0-100000']);
    expect(split(new Uint8Array(1000), READ, new Uint8Array(1000))).toEqual([
      'gap 0-1000',
      'request 1000-1008',
      'gap 1008-2008',
    ]);
  });
});

describe('directions', () => {
  test('a write and its echo', () => {
    expect(split(WRITE, WRITE)).toEqual(['request 0-8', 'response 8-16']);
    expect(split(READ, asRtu(1, [0x83, 2]), WRITE, WRITE, READ)).toEqual([
      'request 0-8',
      'response 8-13',
      'request 13-21',
      'response 21-29',
      'request 29-37',
    ]);
  });

  test('two writes of different values are no request and reply', () => {
    const other = asRtu(0x11, [0x06, 0, 1, 0, 4]);
    expect(split(WRITE, WRITE, other, other)).toEqual([
      'request 0-8',
      'response 8-16',
      'request 16-24',
      'response 24-32',
    ]);
    expect(split([0xff], WRITE, other, [0xff])).toEqual(['gap 0-1', 'response 1-9', 'request 9-17', 'gap 17-18']);
  });

  test('one that was refused, and one behind a reply, are requests', () => {
    const refused = asRtu(0x11, [0x86, 2]);
    expect(split(WRITE, refused)).toEqual(['request 0-8', 'response 8-13']);
    expect(split(REPLY, WRITE, [0xff])).toEqual(['response 0-11', 'request 11-19', 'gap 19-20']);
  });

  test('the partner that is damaged tells too', () => {
    const damaged = WRITE.with(5, 0x83);
    expect(split([0xff], WRITE, damaged, [0xff])).toEqual(['gap 0-1', 'request 1-9', 'gap 9-18']);
    expect(split([0xff], damaged, WRITE, [0xff])).toEqual(['gap 0-9', 'response 9-17', 'gap 17-18']);
  });

  test('alone it can be either', () => {
    expect(split(WRITE)).toEqual(['either 0-8']);
    expect(split([0xff], WRITE, [0xff])).toEqual(['gap 0-1', 'either 1-9', 'gap 9-10']);
  });

  test('a broadcast has no reply', () => {
    const all = asRtu(0, [0x06, 0, 1, 0, 3]);
    expect(split(READ, asRtu(1, [0x83, 2]), all, READ)).toEqual([
      'request 0-8',
      'response 8-13',
      'request 13-21',
      'request 21-29',
    ]);
  });
});

describe('functions whose length no byte tells', () => {
  test('08 sub-function 00 with one word is found anywhere', () => {
    const query = asRtu(1, [0x08, 0, 0, 0xa5, 0x37]);
    expect(split([0xff, 0xff], query, query, READ)).toEqual([
      'gap 0-2',
      'request 2-10',
      'response 10-18',
      'request 18-26',
    ]);
  });

  test('others where they fill the place between frames', () => {
    const asked = asRtu(1, [0x41, 1, 2, 3]);
    const answer = asRtu(1, [0x41, 9, 8, 7, 6, 5]);
    expect(split(REPLY, asked, answer, READ)).toEqual([
      'response 0-11',
      'request 11-18',
      'response 18-27',
      'request 27-35',
    ]);
    expect(split(REPLY, asked, [9], READ)).toEqual(['response 0-11', 'gap 11-19', 'request 19-27']);
  });
});

describe('other transports', () => {
  test('TCP', () => {
    const asked = asTcp(1, [0x03, 0, 0, 0, 2], 7);
    const answer = asTcp(1, [0x03, 4, 0, 1, 0, 2], 7);
    const segments = splitStream(Uint8Array.of(...asked, ...answer));
    expect(segments.map(say)).toEqual(['request 0-12', 'response 12-25']);
    expect(segments[0]).toMatchObject({ kind: 'frame', transport: 'tcp' });
  });

  test('ASCII, with other characters between', () => {
    const asked = characters(':010300000001FB\r\n');
    const answer = asAscii(1, [0x03, 2, 0, 5]);
    const segments = splitStream(Uint8Array.of(...asked, ...answer, 0x20, ...asked));
    expect(segments.map(say)).toEqual(['request 0-17', 'response 17-32', 'gap 32-33', 'request 33-50']);
    expect(segments[0]).toMatchObject({ kind: 'frame', transport: 'ascii' });
  });
});

describe('streams made to be hard', () => {
  const repeated = (part: readonly number[], times: number) =>
    Uint8Array.from({ length: part.length * times }, (_, i) => part[i % part.length] as number);

  test('a million bytes of TCP frames that each overlap the next', () => {
    // 07 asked of unit 1; its unit and function code are the next one's transaction.
    const bytes = repeated([0x01, 0x07, 0, 0, 0, 2], 300_000);
    expectCovered(splitStream(bytes), bytes.length);
  });

  test('as many frames whose length no byte tells', () => {
    const frame = [...asRtu(1, [0x41])];
    const segments = splitStream(repeated(frame, 300_000));
    expect(segments).toHaveLength(300_000);
    expectCovered(segments, 1_200_000);
  });
});

describe('properties', () => {
  test('any bytes: every byte once, and never a throw', () => {
    fc.assert(
      fc.property(fc.array(anyBytes, { maxLength: 4 }), (parts) => {
        const bytes = Uint8Array.from(parts.flatMap((part) => [...part]));
        expectCovered(splitStream(bytes), bytes.length);
      }),
      { numRuns: 500 },
    );
  });

  /** RTU frames whose length some byte tells: not raw data, 08 sub-function 00, or 2B/0D. */
  const told = frames
    .filter(
      ({ transport, functionCode, fields }) =>
        transport === 'rtu' && !('meiData' in fields) && !('data' in fields && functionCode !== 0x11),
    )
    .map((frame) => ({ ...frame, bytes: hex(frame.hex) }));

  test('frames of the vectors end to end are all found', () => {
    expect(told.length).toBeGreaterThan(200);
    fc.assert(
      fc.property(fc.array(fc.constantFrom(...told), { minLength: 2, maxLength: 12 }), (chosen) => {
        const bytes = Uint8Array.from(chosen.flatMap((frame) => [...frame.bytes]));
        const segments = splitStream(bytes);
        expectCovered(segments, bytes.length);
        expect(segments.map(({ kind, to }) => `${kind} ${to}`)).toEqual(
          chosen.map((_, i) => `frame ${chosen.slice(0, i + 1).reduce((sum, frame) => sum + frame.bytes.length, 0)}`),
        );
      }),
      { numRuns: 300 },
    );
  });

  test('frames end to end keep their direction where they have only one', () => {
    const oneWay = told.filter(({ functionCode }) => ![5, 6, 8, 0x15, 0x16, 1, 2, 0x14].includes(functionCode));
    fc.assert(
      fc.property(fc.array(fc.constantFrom(...oneWay), { minLength: 2, maxLength: 8 }), (chosen) => {
        const bytes = Uint8Array.from(chosen.flatMap((frame) => [...frame.bytes]));
        expect(splitStream(bytes)).toMatchObject(chosen.map(({ direction }) => ({ direction })));
      }),
      { numRuns: 300 },
    );
  });
});
