import { readFileSync } from 'node:fs';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  asciiGapEffect,
  bitsPerCharacter,
  bitsTime,
  charactersTime,
  countedSilences,
  formatStanding,
  hasFixedSilences,
  readSerialFormat,
  rtuGapEffect,
  rtuSilences,
  type SerialFormat,
  serialFormatName,
  serialFormats,
} from '../../../../src/modbus/index.ts';

interface Row {
  readonly baud: number;
  readonly format: string;
  readonly bitsPerChar: number;
  readonly tCharUs: number;
  readonly t15FormulaUs: number;
  readonly t35FormulaUs: number;
  readonly t15SpecUs: number;
  readonly t35SpecUs: number;
  readonly charsPerSecond: number;
  readonly maxRtuFrame256Ms: number;
  readonly rtuReadRequest8BytesMs: number;
  readonly asciiMaxFrame513Ms: number;
}

const { rows } = JSON.parse(readFileSync(new URL('../../../vectors/timing.json', import.meta.url), 'utf8')) as {
  rows: readonly Row[];
};

const format = (name: string): SerialFormat => readSerialFormat(name)!;

/** The table is printed with three decimals, halves rounded either way. */
const expectPrinted = (got: number, printed: number) => expect(Math.abs(got - printed)).toBeLessThanOrEqual(0.000501);

describe('the published table', () => {
  it('has every speed in every format', () => expect(rows.length).toBe(22 * 7));

  it.each(rows)('$baud $format', (row) => {
    const line = { ...format(row.format), baud: row.baud };
    const bits = bitsPerCharacter(line);
    const counted = countedSilences(row.baud, bits);
    const rule = rtuSilences(row.baud, bits);
    expect(bits).toBe(row.bitsPerChar);
    expectPrinted(bitsTime(row.baud, bits), row.tCharUs);
    expectPrinted(counted.t15, row.t15FormulaUs);
    expectPrinted(counted.t35, row.t35FormulaUs);
    expectPrinted(rule.t15, row.t15SpecUs);
    expectPrinted(rule.t35, row.t35SpecUs);
    expect(charactersTime(line, row.charsPerSecond) / 1e6).toBeCloseTo(1, 5);
    expectPrinted(charactersTime(line, 256) / 1000, row.maxRtuFrame256Ms);
    expectPrinted(charactersTime(line, 8) / 1000, row.rtuReadRequest8BytesMs);
    expectPrinted(charactersTime(line, 513) / 1000, row.asciiMaxFrame513Ms);
  });
});

describe('formats', () => {
  it.each([
    ['7N1', 9], // start, 7 data, stop
    ['7E1', 10], // start, 7 data, parity, stop (SL 2.5.2)
    ['7O1', 10],
    ['7N2', 10], // no parity: 2 stop bits (SL 2.5.2)
    ['7E2', 11],
    ['7O2', 11],
    ['8N1', 10], // start, 8 data, stop
    ['8N2', 11], // no parity: 2 stop bits (SL 2.5.1)
    ['8E1', 11], // start, 8 data, parity, stop (SL 2.5.1)
    ['8O1', 11],
    ['8E2', 12],
    ['8O2', 12],
  ])('%s has %i bits', (name, bits) => expect(bitsPerCharacter(format(name))).toBe(bits));

  it('are twelve, each with a name that reads back', () => {
    expect(new Set(serialFormats.map(serialFormatName)).size).toBe(12);
    for (const each of serialFormats) expect(readSerialFormat(serialFormatName(each))).toEqual(each);
  });

  it('are read as people write them', () => {
    expect(readSerialFormat(' 8e1 ')).toEqual({ dataBits: 8, parity: 'even', stopBits: 1 });
    expect(readSerialFormat('8-N-2')).toEqual({ dataBits: 8, parity: 'none', stopBits: 2 });
    expect(readSerialFormat('7,O,1')).toEqual({ dataBits: 7, parity: 'odd', stopBits: 1 });
    for (const text of ['', '8', '8E', '9E1', '8E3', '8X1', '8E11', '0x8E1']) {
      expect(readSerialFormat(text), text).toBeUndefined();
    }
  });

  it('stand in a mode as SL 2.5.1 and 2.5.2 have them', () => {
    const standings = (mode: 'rtu' | 'ascii') =>
      Object.fromEntries(serialFormats.map((each) => [serialFormatName(each), formatStanding(mode, each)]));
    expect(standings('rtu')).toMatchObject({
      '8E1': 'default',
      '8O1': 'named',
      '8N2': 'named',
      '8N1': 'common',
      '8E2': 'unusual',
      '7E1': 'impossible',
      '7N2': 'impossible',
    });
    expect(standings('ascii')).toMatchObject({
      '7E1': 'default',
      '7O1': 'named',
      '7N2': 'named',
      '8N1': 'common',
      '7N1': 'unusual',
      '8E1': 'unusual',
    });
  });
});

describe('silences (SL 2.5.1.1)', () => {
  it('are counted at 19200 baud, and fixed above it', () => {
    expect(rtuSilences(19_200, 11).t15).toBe(859.375);
    expect(rtuSilences(19_200, 11).t35).toBeCloseTo(2005.208, 3);
    expect(rtuSilences(19_201, 11)).toEqual({ t15: 750, t35: 1750 });
    expect(rtuSilences(4_000_000, 10)).toEqual({ t15: 750, t35: 1750 });
    expect([hasFixedSilences(19_200), hasFixedSilences(19_201)]).toEqual([false, true]);
  });

  it('are 3.646 ms at 9600 counted with 10 bits, and 4.010 ms with 11', () => {
    expect(rtuSilences(9600, 10).t35).toBeCloseTo(3645.833, 3);
    expect(rtuSilences(9600, 11).t35).toBeCloseTo(4010.417, 3);
  });

  it('would be 1750 µs by counting at 22000 baud with 11 bits and at 20000 with 10', () => {
    expect(countedSilences(22_000, 11).t35).toBe(1750);
    expect(countedSilences(20_000, 10).t35).toBe(1750);
  });

  it('inside a frame: up to t1.5 it is whole, below t3.5 discarded, from t3.5 on two frames', () => {
    const at19200 = rtuSilences(19_200, 11);
    expect(rtuGapEffect(0, at19200)).toBe('whole');
    expect(rtuGapEffect(859.375, at19200)).toBe('whole');
    expect(rtuGapEffect(859.376, at19200)).toBe('discarded');
    expect(rtuGapEffect(2005.2, at19200)).toBe('discarded');
    expect(rtuGapEffect(2005.21, at19200)).toBe('two-frames');
    const above = rtuSilences(115_200, 10);
    expect([750, 750.1, 1749.9, 1750].map((gap) => rtuGapEffect(gap, above))).toEqual([
      'whole',
      'discarded',
      'discarded',
      'two-frames',
    ]);
  });

  it('of ASCII: a second may pass between two characters (SL 2.5.2.1)', () => {
    expect([0, 4000, 1_000_000, 1_000_001].map(asciiGapEffect)).toEqual(['whole', 'whole', 'whole', 'discarded']);
  });
});

describe('for any line', () => {
  const bauds = fc.integer({ min: 300, max: 4_000_000 });
  const formats = fc.constantFrom(...serialFormats);

  it('a faster speed never has longer silences', () => {
    fc.assert(
      fc.property(bauds, bauds, formats, (one, other, each) => {
        const bits = bitsPerCharacter(each);
        const [slow, fast] = [Math.min(one, other), Math.max(one, other)].map((baud) => rtuSilences(baud, bits));
        expect(fast!.t15).toBeLessThanOrEqual(slow!.t15);
        expect(fast!.t35).toBeLessThanOrEqual(slow!.t35);
      }),
    );
  });

  it('the time of a frame grows by one character with each character', () => {
    fc.assert(
      fc.property(bauds, formats, fc.nat(600), (baud, each, count) => {
        const line = { ...each, baud };
        const more = charactersTime(line, count + 1) - charactersTime(line, count);
        expect(more).toBeCloseTo(bitsTime(baud, bitsPerCharacter(each)), 4);
      }),
    );
  });

  it('the longer a gap, the worse: whole, discarded, two frames', () => {
    const order = ['whole', 'discarded', 'two-frames'];
    fc.assert(
      fc.property(
        bauds,
        fc.constantFrom(9, 10, 11, 12),
        fc.double({ min: 0, max: 200_000, noNaN: true }),
        (baud, bits, gap) => {
          const silences = rtuSilences(baud, bits);
          const effect = order.indexOf(rtuGapEffect(gap, silences));
          expect(order.indexOf(rtuGapEffect(gap * 1.5, silences))).toBeGreaterThanOrEqual(effect);
          expect(effect).toBe(gap <= silences.t15 ? 0 : gap < silences.t35 ? 1 : 2);
        },
      ),
    );
  });
});
