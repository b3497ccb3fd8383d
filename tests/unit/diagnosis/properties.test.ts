import fc, { type Arbitrary } from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type DiagnoseContext, diagnose } from '../../../src/diagnosis/index.ts';
import { crc16, encodeFrame, framesAt } from '../../../src/modbus/index.ts';
import { anyBytes, anyLegalFrame, anyTransport } from '../modbus/arbitraries.ts';
import { hex } from '../modbus/frames.ts';
import { frames } from '../modbus/vectors.ts';
import { contextOf, isValid, userFrames } from './findings.ts';

const anyContext: Arbitrary<DiagnoseContext> = fc.record(
  {
    transport: anyTransport,
    request: anyBytes,
    preceding: fc.array(anyBytes, { maxLength: 3 }),
    following: fc.array(anyBytes, { maxLength: 3 }),
  },
  { requiredKeys: [] },
);

/** A legal frame of which bytes were changed, lost or added. */
const damaged = fc
  .tuple(anyLegalFrame, fc.array(fc.tuple(fc.nat(300), fc.nat(255), fc.constantFrom(0, 1, 2)), { maxLength: 3 }))
  .map(([input, changes]) => {
    const bytes = Array.from(encodeFrame(input));
    for (const [place, byte, removed] of changes) bytes.splice(place % (bytes.length + 1), removed, byte);
    return Uint8Array.from(bytes);
  });

describe('for any bytes and whatever is known beside them', () => {
  const anything = fc.oneof(anyBytes, damaged);

  it('every finding stands in the bytes, and every repair is valid', () => {
    fc.assert(
      fc.property(anything, anyContext, (bytes, context) => {
        for (const { from, to, repaired } of diagnose(bytes, context)) {
          if (from < 0 || to > bytes.length || from >= to) expect.unreachable(`${from} to ${to} of ${bytes.length}`);
          expect(repaired.filter((frame) => !isValid(frame))).toEqual([]);
        }
      }),
      { numRuns: 150 },
    );
  });

  it('there is a finding, each code once, and the same every time', () => {
    fc.assert(
      fc.property(anything, anyContext, (bytes, context) => {
        const found = diagnose(bytes, context);
        expect(found.length > 0).toBe(bytes.length > 0);
        expect(new Set(found.map(({ code }) => code)).size).toBe(found.length);
        expect(diagnose(bytes, context)).toEqual(found);
      }),
      { numRuns: 80 },
    );
  });

  it('the bytes are left as they are', () => {
    fc.assert(
      fc.property(damaged, (bytes) => {
        const buffer = Buffer.from(bytes);
        diagnose(buffer, { request: buffer });
        expect(buffer.equals(bytes)).toBe(true);
      }),
      { numRuns: 40 },
    );
  });
});

describe('valid frames', () => {
  it('are said to be', () => {
    const wrong = frames
      .map(({ id, transport, hex: bytes, request, direction }) => {
        const known = { transport, ...(direction === 'response' && request ? { request } : {}) };
        return `${id} ${diagnose(hex(bytes), contextOf(known))[0]?.code}`;
      })
      .filter((said) => !/ valid(-exception)?$/.test(said));
    expect(wrong).toEqual([]);
  });
});

describe('garbage', () => {
  /** Numbers that look random and are the same in every run. */
  function randomBytes(seed: number, length: number): Uint8Array {
    let state = seed;
    return new Uint8Array(length).map(() => {
      state ^= state << 13;
      state ^= state >>> 17;
      state ^= state << 5;
      return (state >>> 8) & 0xff;
    });
  }

  const confident = (bytes: Uint8Array, context: DiagnoseContext) =>
    diagnose(bytes, context).filter(({ confidence }) => confidence !== 'possible');

  it.each([
    ['with nothing known', {}],
    ['on an RTU line', { transport: 'rtu' }],
    ['on a TCP connection', { transport: 'tcp' }],
    ['in reply to a request', { transport: 'rtu', request: hex('11 03 00 6B 00 03 76 87') }],
  ] as const)(
    'yields no confident finding, %s',
    (_, context) => {
      const found = Array.from({ length: 200 }, (_unused, i) => {
        const bytes = randomBytes(0x9e3779b9 + i * 7919, 3 + (i % 60));
        return confident(bytes, context).map(({ code }) => `${code} in ${Buffer.from(bytes).toString('hex')}`);
      }).flat();
      expect(found).toEqual([]);
    },
    60_000,
  );

  it('of any length is looked at in part', () => {
    for (const fill of [0x00, 0x01, 0x2b, 0x3a, 0xff]) {
      expect(diagnose(new Uint8Array(10_000_000).fill(fill))).toHaveLength(1);
    }
    const [found] = diagnose(randomBytes(1, 10_000_000));
    expect(found).toMatchObject({ code: 'noise', repaired: [] });
    expect(found!.to).toBeLessThanOrEqual(4096);
  });

  it('in which chance puts a frame is not taken for it', () => {
    // Somewhere in so much garbage the CRC of five bytes holds, as if they were an exception.
    const bytes = randomBytes(77, 4096);
    const at = 2000;
    bytes.set([0x11, 0x83, 0x02], at);
    const crc = crc16(bytes, at, at + 3);
    bytes.set([crc & 0xff, crc >>> 8], at + 3);
    expect(framesAt(bytes, at).length).toBeGreaterThan(0);
    expect(diagnose(bytes)[0]).toMatchObject({ code: 'noise', confidence: 'possible' });
  });
});

it('the cases of users are of every layer', () => {
  expect(new Set(userFrames.map(({ transport }) => transport))).toEqual(new Set(['rtu', 'ascii', 'tcp', 'data']));
});
