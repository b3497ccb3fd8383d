import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { byName, flag, listOf, number, oneOf, record, someOf, text, whole } from '../../../src/workbench/stored.ts';

describe('a decoder of what is stored', () => {
  it('takes a number within its limits, and whole where it must be', () => {
    expect([50, 9600, 4_000_000].map(whole(50, 4_000_000))).toEqual([50, 9600, 4_000_000]);
    for (const wrong of [49, 4_000_001, -5, 9600.5, '9600', null, undefined, true, [9600], {}])
      expect(whole(50, 4_000_000)(wrong)).toBeUndefined();
    expect([0, 0.5, 2000].map(number(0, 2000))).toEqual([0, 0.5, 2000]);
    for (const wrong of [-0.1, 2000.1, Number.NaN, '1', null]) expect(number(0, 2000)(wrong)).toBeUndefined();
  });

  it('takes only what is listed', () => {
    const parity = oneOf(['none', 'even', 'odd']);
    expect(parity('even')).toBe('even');
    for (const wrong of ['purple', 'EVEN', '', 'constructor', ['even'], 0, null]) expect(parity(wrong)).toBeUndefined();
    expect(oneOf([7, 8])(8)).toBe(8);
    expect(oneOf([7, 8])('8')).toBeUndefined();
  });

  it('takes of a list of choices those that exist, in their order and once each', () => {
    const speeds = someOf([1200, 2400, 9600]);
    expect(speeds([9600, 1200, 9600, 7, 'x'])).toEqual([1200, 9600]);
    expect(speeds([])).toEqual([]);
    for (const wrong of [{}, '9600', 9600, null]) expect(speeds(wrong)).toBeUndefined();
  });

  it('takes texts and flags as they are, and texts only if they are allowed', () => {
    expect(text()('')).toBe('');
    expect(text((format) => format.length === 3)('8E1')).toBe('8E1');
    expect(text((format) => format.length === 3)('8E11')).toBeUndefined();
    expect(text()(7)).toBeUndefined();
    expect([flag(true), flag(false), flag(0), flag('true')]).toEqual([true, false, undefined, undefined]);
  });

  it('takes a list only whole, and of values by name those that are legal', () => {
    expect(listOf(text())(['a', 'b'])).toEqual(['a', 'b']);
    expect(listOf(text())(['a', 1])).toBeUndefined();
    expect(listOf(text())({ length: 0 })).toBeUndefined();
    const lines = byName(listOf(text()));
    const stored: unknown = JSON.parse('{"x": ["a"], "y": "a", "__proto__": ["b"], "constructor": []}');
    expect(Object.entries(lines(stored)!)).toEqual([
      ['x', ['a']],
      ['__proto__', ['b']],
      ['constructor', []],
    ]);
    for (const wrong of [[], null, 'x']) expect(lines(wrong)).toBeUndefined();
  });
});

interface Line {
  readonly baud: number;
  readonly parity: 'none' | 'even' | 'odd';
  readonly rts: boolean;
  readonly delay: number;
  readonly speeds: readonly number[];
}
const defaults: Line = { baud: 19_200, parity: 'even', rts: false, delay: 5, speeds: [] };
const parities = ['none', 'even', 'odd'] as const;
const speeds = [1200, 9600];
const line = record<Line>(
  { baud: whole(50, 4_000_000), parity: oneOf(parities), rts: flag, delay: number(0, 2000), speeds: someOf(speeds) },
  defaults,
);

describe('stored settings', () => {
  it('keep what is legal, field by field', () => {
    expect(line({ baud: -5, parity: 'purple', rts: true, dataBits: 99 })).toEqual({ ...defaults, rts: true });
    expect(line({ baud: 9600, parity: 'odd', rts: 'yes', delay: 0 })).toEqual({
      ...defaults,
      baud: 9600,
      parity: 'odd',
      delay: 0,
    });
    for (const nothing of [undefined, null, 7, '', [], {}]) expect(line(nothing)).toEqual(defaults);
  });

  it('read no field from what every object has', () => {
    const names = record<{ readonly constructor: string }>({ constructor: text() }, { constructor: 'x' });
    expect(names({}).constructor).toBe('x');
    expect(names({ constructor: 'y' }).constructor).toBe('y');
    expect(line(JSON.parse('{"__proto__": {"baud": 9600}}'))).toEqual(defaults);
  });

  it('come out legal from any JSON', () => {
    const field = fc.oneof(fc.jsonValue(), fc.integer(), fc.constantFrom(...parities));
    const like = fc.record(
      { baud: field, parity: field, rts: field, delay: field, speeds: field },
      { requiredKeys: [] },
    );
    fc.assert(
      fc.property(fc.oneof(fc.jsonValue(), like), (stored) => {
        const { baud, parity, rts, delay, speeds: some, ...more } = line(stored);
        expect(more).toEqual({});
        expect(Number.isInteger(baud) && baud >= 50 && baud <= 4_000_000).toBe(true);
        expect(parities).toContain(parity);
        expect(typeof rts).toBe('boolean');
        expect(delay >= 0 && delay <= 2000).toBe(true);
        expect(some.every((speed) => speeds.includes(speed))).toBe(true);
      }),
    );
  });

  it('come back as they were stored', () => {
    const legal = fc.record({
      baud: fc.integer({ min: 50, max: 4_000_000 }),
      parity: fc.constantFrom(...parities),
      rts: fc.boolean(),
      delay: fc.double({ min: 0, max: 2000, noNaN: true }).map((delay) => delay + 0),
      speeds: fc.subarray(speeds),
    });
    fc.assert(
      fc.property(legal, (settings) => {
        expect(line(JSON.parse(JSON.stringify(settings)))).toEqual(settings);
      }),
    );
  });
});
