import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type CrcAlgorithm, CrcSteps, crc, crcCatalogue } from '../../../../src/modbus/index.ts';
import { hex } from '../frames.ts';
import { byBits } from './by-bits.ts';

const modbus = crcCatalogue.find(({ name }) => name === 'CRC-16/MODBUS')!;
const rows = crcCatalogue.map((row) => [row.name, row] as const);

/** Parameters of the RevEng catalogue of widths that are no whole bytes. */
const odd: readonly (readonly [string, CrcAlgorithm])[] = [
  ['CRC-3/GSM', { width: 3, poly: 0x3, init: 0, refin: false, refout: false, xorout: 0x7 }],
  ['CRC-3/ROHC', { width: 3, poly: 0x3, init: 0x7, refin: true, refout: true, xorout: 0 }],
  ['CRC-5/USB', { width: 5, poly: 0x05, init: 0x1f, refin: true, refout: true, xorout: 0x1f }],
  ['CRC-7/MMC', { width: 7, poly: 0x09, init: 0, refin: false, refout: false, xorout: 0 }],
  ['CRC-12/UMTS', { width: 12, poly: 0x80f, init: 0, refin: false, refout: true, xorout: 0 }],
  [
    'CRC-31/PHILIPS',
    { width: 31, poly: 0x04c11db7, init: 0x7fffffff, refin: false, refout: false, xorout: 0x7fffffff },
  ],
];

/** Any parameters of 1 to 32 bits. */
const anyAlgorithm = fc.integer({ min: 1, max: 32 }).chain((width) => {
  const value = fc.integer({ min: 0, max: 2 ** width - 1 });
  return fc.record({
    width: fc.constant(width),
    poly: value,
    init: value,
    refin: fc.boolean(),
    refout: fc.boolean(),
    xorout: value,
  });
});

const shiftsOf = (steps: CrcSteps, at: number) =>
  steps.shifts(at).map(({ before, out, after }) => [before, out, after]);

function expectByBits(algorithm: CrcAlgorithm, bytes: Uint8Array): void {
  const steps = new CrcSteps(algorithm, bytes);
  const expected = byBits(algorithm, bytes);
  expect([...steps.registers]).toEqual(expected.registers);
  for (let at = 0; at < bytes.length; at++) {
    expect(steps.byte(at).mixed).toBe(expected.mixed[at]);
    expect(shiftsOf(steps, at)).toEqual(expected.shifts[at]);
  }
}

describe('the example of the specification, 02 07 (SL 6.2)', () => {
  const steps = new CrcSteps(modbus, hex('02 07'));

  it('has these registers', () => {
    expect(steps.byte(0)).toMatchObject({ value: 0x02, before: 0xffff, mixed: 0xfffd, after: 0x813e });
    expect(shiftsOf(steps, 0)).toEqual([
      [0xfffd, 1, 0xdfff],
      [0xdfff, 1, 0xcffe],
      [0xcffe, 0, 0x67ff],
      [0x67ff, 1, 0x93fe],
      [0x93fe, 0, 0x49ff],
      [0x49ff, 1, 0x84fe],
      [0x84fe, 0, 0x427f],
      [0x427f, 1, 0x813e],
    ]);
    expect(steps.byte(1)).toMatchObject({ value: 0x07, before: 0x813e, mixed: 0x8139, after: 0x1241 });
    expect(shiftsOf(steps, 1)).toEqual([
      [0x8139, 1, 0xe09d],
      [0xe09d, 1, 0xd04f],
      [0xd04f, 1, 0xc826],
      [0xc826, 0, 0x6413],
      [0x6413, 1, 0x9208],
      [0x9208, 0, 0x4904],
      [0x4904, 0, 0x2482],
      [0x2482, 0, 0x1241],
    ]);
    expect(steps.value).toBe(0x1241);
  });

  it('has them by another computation too', () => {
    expectByBits(modbus, hex('02 07'));
  });

  it('has these entries of the table', () => {
    // 0xFD: the low byte of FFFD. 0x39: the low byte of 8139.
    expect(steps.byte(0)).toMatchObject({ index: 0xfd, entry: 0x81c1, moved: 0x00ff });
    expect(steps.byte(1)).toMatchObject({ index: 0x39, entry: 0x12c0, moved: 0x0081 });
  });
});

describe('the frame of the guide, 06 06 02 AB 10 00', () => {
  it('has these registers', () => {
    const steps = new CrcSteps(modbus, hex('06 06 02 AB 10 00'));
    expect([...steps.registers]).toEqual([0xffff, 0x423f, 0x1282, 0xa013, 0x72a0, 0xb473, 0xe5f5]);
    expect(shiftsOf(steps, 0).map(([, , after]) => after)).toEqual([
      0xdffd, 0xcfff, 0xc7fe, 0x63ff, 0x91fe, 0x48ff, 0x847e, 0x423f,
    ]);
    expectByBits(modbus, hex('06 06 02 AB 10 00'));
  });
});

describe('every algorithm', () => {
  it.each([...rows, ...odd])('%s: all that lies between, by another computation', (_, row) => {
    expectByBits(row, hex('00 FF 31 80 01 A5'));
  });

  it.each([...rows, ...odd])('%s: the last register is its CRC', (_, row) => {
    fc.assert(
      fc.property(fc.uint8Array({ maxLength: 40 }), (bytes) => new CrcSteps(row, bytes).value === crc(row, bytes)),
      { numRuns: 20 },
    );
  });

  it('has the check values of the catalogue', () => {
    const check = Uint8Array.from('123456789', (one) => one.charCodeAt(0));
    for (const [, row] of rows) expect(new CrcSteps(row, check).value).toBe(row.check);
    // As RevEng lists them.
    expect(odd.map(([, row]) => new CrcSteps(row, check).value)).toEqual([0x4, 0x6, 0x19, 0x75, 0xdaf, 0x0ce9e46c]);
  });

  it('has any parameters', () => {
    fc.assert(
      fc.property(anyAlgorithm, fc.uint8Array({ maxLength: 12 }), (row, bytes) => {
        expectByBits(row, bytes);
        expect(new CrcSteps(row, bytes).value).toBe(crc(row, bytes));
      }),
    );
  });

  it('has the same by its table as by its shifts, because the other bits only move', () => {
    fc.assert(
      fc.property(anyAlgorithm, fc.uint8Array({ minLength: 1, maxLength: 6 }), (row, bytes) => {
        const steps = new CrcSteps(row, bytes);
        for (let at = 0; at < bytes.length; at++) {
          const { mixed, moved, entry, after } = steps.byte(at);
          expect(after).toBe(steps.shifts(at)[7]!.after);
          const split = steps.split(at);
          expect(split).toHaveLength(9);
          expect(split[0]!.whole).toBe(mixed);
          expect(split[8]).toEqual({ whole: after, index: entry, rest: moved });
          for (const { whole, index, rest } of split) expect(whole).toBe((index ^ rest) >>> 0);
        }
      }),
    );
  });

  it.each([0, 33, 2.5])('refuses a width of %s', (width) => {
    const row = { width, poly: 1, init: 0, refin: false, refout: false, xorout: 0 };
    expect(() => new CrcSteps(row, hex('00'))).toThrow(RangeError);
  });
});

it('says nothing of no bytes but the CRC of none', () => {
  const steps = new CrcSteps(modbus, new Uint8Array());
  expect([...steps.registers]).toEqual([0xffff]);
  expect(steps.value).toBe(0xffff);
});

it('reflects the register where output and input differ, before the final xor', () => {
  // CRC-12/UMTS moves to the left, and its value is turned round: DAF is F5B backwards.
  const steps = new CrcSteps(
    odd[4]![1],
    Uint8Array.from('123456789', (one) => one.charCodeAt(0)),
  );
  expect(steps.last).toBe(0xf5b);
  expect(steps.unxored).toBe(0xdaf);
});
