import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { type IdentifyContext, type Identity, identify, type Reason } from '../../../src/diagnosis/index.ts';
import { identify as words } from '../../../src/words/en/identify.ts';
import { anyBytes } from '../modbus/arbitraries.ts';
import { characters, hex } from '../modbus/frames.ts';
import { brokenFrames, frames, userFrames } from '../modbus/vectors.ts';

const say = ({ transport, direction }: Identity) => `${transport} ${direction}`;

/** What the bytes most probably are; several where they are equally likely. */
function first(bytes: Uint8Array, context?: IdentifyContext): string[] {
  const found = identify(bytes, context);
  return found.filter(({ weight }) => weight === found[0]?.weight).map(say);
}

const sentence = (reason: Reason): string => (words.reasons[reason.code] as (one: Reason) => string)(reason);

/** The best identity in words. */
const said = (bytes: Uint8Array, context?: IdentifyContext): string[] | undefined =>
  identify(bytes, context)[0]?.reasons.map(sentence);

describe('whole frames', () => {
  test.each([
    { what: 'a read', hex: '01 03 00 85 00 01 95 E3', found: ['rtu request'] },
    { what: 'registers', hex: '05 03 02 F4 01 CE 84', found: ['rtu response'] },
    { what: 'an exception', hex: '01 83 02 C0 F1', found: ['rtu response'] },
    { what: 'a write that its reply echoes', hex: '11 06 00 01 00 03 9A 9B', found: ['rtu request', 'rtu response'] },
    // Its bytes are those of an MBAP with length 2 as well.
    { what: 'two registers from 0', hex: '01 03 00 00 00 02 C4 0B', found: ['rtu request'] },
    { what: 'the same with a wrong CRC', hex: '01 03 00 00 00 02 C4 0A', found: ['rtu request'] },
    { what: 'a read on TCP', hex: '00 01 00 00 00 06 01 03 A0 3C 00 01', found: ['tcp request'] },
    { what: 'an exception on TCP', hex: '00 01 00 00 00 03 01 83 02', found: ['tcp response'] },
    { what: 'a bare PDU', hex: '03 00 6B 00 03', found: ['pdu request'] },
    { what: 'a bare PDU with a byte count', hex: '03 04 00 06 00 05', found: ['pdu response'] },
  ])('$what', ({ hex: text, found }) => {
    expect(first(hex(text))).toEqual(found);
  });

  test('characters, with and without their line end', () => {
    expect(first(characters(':010300000001FB\r\n'))).toEqual(['ascii request']);
    expect(first(characters(':010300000001FB'))).toEqual(['ascii request']);
    expect(first(characters(':0183027A\r\n'))).toEqual(['ascii response']);
  });

  test('a valid frame followed by 00 is too long, though its CRC leaves no residue', () => {
    const [best] = identify(hex('11 03 00 6B 00 03 76 87 00'));
    expect(best).toMatchObject({ transport: 'rtu', direction: 'request' });
    expect(best?.reading.outcome).toEqual({ kind: 'extra', bytes: 1 });
  });

  test('of a thousand frames end to end the first counts, and all bytes are read', () => {
    const frame = hex('01 03 00 85 00 01 95 E3');
    const bytes = Uint8Array.from({ length: 8000 }, (_, i) => frame[i % 8] as number);
    const [best] = identify(bytes);
    expect(best).toMatchObject({ transport: 'rtu', direction: 'request' });
    expect(best?.reading.outcome).toEqual({ kind: 'extra', bytes: 7992 });
    expect(said(bytes)).toContain('7,992 bytes too many');
  });

  test('no bytes are nothing', () => {
    expect(identify(new Uint8Array(0))).toEqual([]);
  });
});

describe('broken frames', () => {
  test.each([
    { what: 'a wrong CRC', hex: '01 03 00 29 00 01 83 01', found: ['rtu request'] },
    { what: 'CRC bytes exchanged', hex: '01 03 02 01 84 B7 B9', found: ['rtu response'] },
    { what: 'no CRC at all', hex: '01 03 00 29 00 01', found: ['rtu request'] },
    { what: 'one byte missing', hex: '01 04 00 00 00 01 FA', found: ['rtu request'] },
    { what: 'cut inside its registers', hex: '01 03 3E 00 71 02 7B', found: ['rtu response'] },
    { what: 'a stray byte in front', hex: 'FF 01 06 0F 9F 00 00 BA F0', found: ['rtu request', 'rtu response'] },
    // 41 is a user-defined function, whose PDU may hold anything.
    { what: 'one that might begin a PDU', hex: '41 01 83 02 C0 F1', found: ['rtu response'] },
    { what: 'stray bytes around', hex: '00 04 83 02 D0 F0 00', found: ['rtu response'] },
    { what: 'an MBAP length too large', hex: '18 58 00 00 00 04 01 83 03', found: ['tcp response'] },
    { what: 'a stray byte before an MBAP', hex: 'FF 00 01 00 00 00 03 01 83 02', found: ['tcp response'] },
  ])('$what', ({ hex: text, found }) => {
    expect(first(hex(text))).toEqual(found);
  });

  test('characters with a wrong LRC, a blank, without the colon', () => {
    expect(first(characters(':010300000001FC\r\n'))).toEqual(['ascii request']);
    expect(first(characters(':0103 00000001FB\r\n'))).toEqual(['ascii request']);
    expect(first(characters('010300000001FB\r\n'))).toEqual(['ascii request']);
  });
});

describe('what else is known decides', () => {
  const write = '11 06 00 01 00 03 9A 9B';

  test('the request that is answered', () => {
    const found = identify(hex(write), { request: hex(write) });
    expect(found.slice(0, 2).map(say)).toEqual(['rtu response', 'rtu request']);
    expect(found[0]?.reading.request?.functionCode).toBe(6);
  });

  test('a reply to another unit is a reply', () => {
    const found = identify(hex('17 06 40 03 00 17 2E F2'), { request: hex('01 06 40 03 00 17 2C 04') });
    expect(found.slice(0, 2).map(say)).toEqual(['rtu response', 'rtu request']);
  });

  test('an echo of what has no such reply stays a request', () => {
    const request = hex('04 03 20 02 00 02 6E 5E');
    expect(first(request, { request })).toEqual(['rtu request']);
    expect(first(request.subarray(0, 7), { request })).toEqual(['rtu request']);
  });

  test('the direction given', () => {
    expect(first(hex(write), { direction: 'response' })).toEqual(['rtu response']);
    expect(first(hex(write), { direction: 'request' })).toEqual(['rtu request']);
  });

  test('a direction or a transport that is impossible decides nothing', () => {
    const read = hex('01 03 00 85 00 01 95 E3');
    expect(first(read, { direction: 'response' })).toEqual(['rtu request']);
    expect(first(read, { transport: 'tcp' })).toEqual(['rtu request']);
  });

  test('the transport given, where two fit alike', () => {
    // Three registers without unit and CRC, or a write to unit 3 with a wrong one.
    const bytes = hex('03 06 DE AD BE EF 12 34');
    expect(first(bytes, { transport: 'pdu' })).toEqual(['pdu response']);
    expect(first(bytes, { transport: 'rtu' })).toEqual(['rtu request', 'rtu response']);
  });
});

describe('reasons', () => {
  test('a reply with registers', () => {
    expect(said(hex('11 03 08 00 01 00 02 00 03 00 04 0D 14'))).toEqual([
      'CRC does not hold',
      'function 03 is known',
      'byte count 8 = 4 registers',
    ]);
    expect(said(hex('05 03 02 F4 01 CE 84'))).toEqual([
      'CRC holds',
      'function 03 is known',
      'byte count 2 = 1 register',
    ]);
  });

  test('coils, an exception, TCP, ASCII', () => {
    expect(said(hex('01 01 01 05 91 8B'))).toEqual(['CRC holds', 'function 01 is known', 'byte count 1 is right']);
    expect(said(hex('01 83 02 C0 F1'))).toEqual([
      'CRC holds',
      'an exception to function 03',
      'the length is right for this function',
    ]);
    expect(said(hex('00 01 00 00 00 06 01 03 A0 3C 00 01'))).toEqual([
      'MBAP header: protocol identifier 0, and its length, 6, is right',
      'function 03 is known',
      'the length is right for this function',
    ]);
    expect(said(characters(':010300000001FB\r'))).toEqual([
      'starts with a colon',
      'all characters are hexadecimal digits',
      'LRC holds',
      'function 03 is known',
      'the length is right for this function',
      'at least 1 byte missing',
    ]);
  });

  test('of a frame among stray bytes they are the frame’s', () => {
    const request = hex('04 03 01 21 00 01 D5 A9');
    expect(said(hex('00 04 83 02 D0 F0 00'), { request })).toEqual([
      'a whole frame is in bytes 1 to 5, with others around it',
      'CRC holds',
      'an exception to function 03',
      'the length is right for this function',
      'answers the request',
    ]);
  });

  test('in one sentence', () => {
    const summary = (text: string) => identify(hex(text)).slice(0, 1).map(words.summary);
    expect(summary('01 03 10 11 02 FF F8 04 42 FF FE 2E 32 00 0A 2E 32 00 0A F8 D5')).toEqual([
      'RTU: CRC holds; reply: function 03 is known, byte count 16 = 8 registers',
    ]);
    expect(summary('00 01 00 00 00 03 01 83 02')).toEqual([
      'TCP: MBAP header: protocol identifier 0, and its length, 3, is right; reply: an exception to function 03, the length is right for this function',
    ]);
    expect(summary('01')).toEqual(['RTU; request: at least 3 bytes missing']);
  });

  test('a write that its reply echoes', () => {
    expect(said(hex('11 06 00 01 00 03 9A 9B'), { direction: 'request' })).toEqual([
      'CRC holds',
      'function 06 is known',
      'the length is right for this function',
      'request and reply look the same',
      'the direction is as given',
    ]);
  });
});

describe('collected frames', () => {
  test('every valid one comes first, or among those equally likely', () => {
    const others = frames.filter(
      ({ hex: text, transport, direction }) => !first(hex(text)).includes(`${transport} ${direction}`),
    );
    expect(others.map(({ id }) => id)).toEqual([]);
  });

  test('a reply comes first with its request', () => {
    const others = frames
      .filter(({ request }) => request !== undefined)
      .filter(
        ({ hex: text, request = '' }) => identify(hex(text), { request: hex(request) })[0]?.direction !== 'response',
      );
    expect(others.map(({ id }) => id)).toEqual([]);
  });

  test('of the broken ones at most three come with another transport', () => {
    const others = brokenFrames.filter(({ hex: text, transport }) => identify(hex(text))[0]?.transport !== transport);
    // One is a valid RTU frame. One stands among them twice, as RTU and as TCP. The last ends behind its MBAP.
    expect(others.map(({ hex: text }) => text)).toEqual(['02100000000241FB', '020F00000004010FFFFF', '00010000000611']);
  });

  test('all that people asked about come with their transport', () => {
    expect(userFrames).toHaveLength(39);
    const others = userFrames.filter(({ hex: text, answering, transport }) => {
      const request = answering === undefined ? undefined : hex(answering);
      return transport !== 'data' && identify(hex(text), { request })[0]?.transport !== transport;
    });
    expect(others.map(({ id }) => id)).toEqual([]);
  });

  /** The share of the RTU and TCP frames that still come with their transport, and with their direction too. */
  function survive(harm: (bytes: readonly number[]) => readonly number[]): { transport: number; both: number } {
    const harmed = frames.filter(({ transport }) => transport === 'rtu' || transport === 'tcp');
    let transports = 0;
    let both = 0;
    for (const { hex: text, transport, direction } of harmed) {
      const bytes = Uint8Array.from(harm([...hex(text)]));
      if (identify(bytes)[0]?.transport === transport) transports++;
      if (first(bytes).includes(`${transport} ${direction}`)) both++;
    }
    return { transport: transports / harmed.length, both: both / harmed.length };
  }

  test.each<{ what: string; harm: (bytes: readonly number[]) => readonly number[]; transport: number; both: number }>([
    { what: 'the last byte missing', harm: (b) => b.slice(0, -1), transport: 0.95, both: 0.92 },
    { what: 'a byte in front', harm: (b) => [0xff, ...b], transport: 0.99, both: 0.99 },
    { what: 'a byte behind', harm: (b) => [...b, 0], transport: 0.99, both: 0.97 },
    { what: 'bytes around', harm: (b) => [0, ...b, 0], transport: 0.99, both: 0.96 },
    { what: 'no checksum', harm: (b) => [...b.slice(0, -2), 0, 0], transport: 0.99, both: 0.96 },
    { what: 'its first byte changed', harm: ([a = 0, ...b]) => [a ^ 0x10, ...b], transport: 0.99, both: 0.98 },
    {
      what: 'a byte in the middle changed',
      harm: (b) => b.map((byte, i) => (i === b.length >> 1 ? byte ^ 0x10 : byte)),
      transport: 0.98,
      both: 0.95,
    },
  ])('with $what', ({ harm, transport, both }) => {
    const share = survive(harm);
    expect(share.transport).toBeGreaterThanOrEqual(transport);
    expect(share.both).toBeGreaterThanOrEqual(both);
  });
});

describe('any bytes', () => {
  test('are something, ranked, with readings of all of them', () => {
    const context = fc.record(
      {
        request: anyBytes,
        direction: fc.constantFrom('request' as const, 'response' as const),
        transport: fc.constantFrom('rtu' as const, 'ascii' as const, 'tcp' as const, 'pdu' as const),
      },
      { requiredKeys: [] },
    );
    fc.assert(
      fc.property(anyBytes, context, (bytes, known) => {
        const found = identify(bytes, known);
        expect(found.length > 0).toBe(bytes.length > 0);
        for (const [i, { transport, direction, reading, reasons, weight }] of found.entries()) {
          expect(weight).toBeLessThanOrEqual(found[i - 1]?.weight ?? Number.POSITIVE_INFINITY);
          expect(reading).toMatchObject({ transport, direction });
          expect(reading.spans[reading.spans.length - 1]?.to).toBe(bytes.length);
          for (const reason of reasons) expect(sentence(reason)).not.toMatch(/undefined|NaN|^$/);
        }
        expect(new Set(found.map(say)).size).toBe(found.length);
      }),
      { numRuns: 500 },
    );
  });

  test('a megabyte of the same byte is something, and is read whole', () => {
    for (const byte of [0, 0x3a, 0xff]) {
      const [best] = identify(new Uint8Array(1_000_000).fill(byte));
      expect(best?.reading.spans[best.reading.spans.length - 1]?.to).toBe(1_000_000);
    }
  });
});

test('bytes that end before the length of an MBAP header do are not less than none', () => {
  const reasons = identify(hex('00 00 00 00'), { transport: 'tcp' }).flatMap((identity) => identity.reasons);
  const missing = reasons.filter(({ code }) => code === 'mbap-length-differs');
  expect(missing.length).toBeGreaterThan(0);
  for (const reason of missing) expect(reason).toMatchObject({ got: 0, expected: 0 });
});
