import { describe, expect, test } from 'vitest';
import { lineOf, readSerialFormat } from '../../../../src/modbus/index.ts';
import {
  characterNear,
  characterPath,
  charactersInSight,
  isInSight,
  roundStep,
  showsBits,
  ticksBetween,
  xOf,
} from '../../../../src/workbench/wire/geometry.ts';

const format = readSerialFormat('8N1')!;
/** Two frames of two bytes at 10 bits a byte, 20 bits apart. */
const line = lineOf([{ bytes: Uint8Array.of(0x01, 0xff) }, { bytes: Uint8Array.of(0x00, 0x55) }], format, {
  lead: 10,
  silence: 20,
  delay: 0,
});
const [first] = line.characters;

describe('the scale', () => {
  test('has round steps', () => {
    expect([0.9, 1, 1.1, 2.1, 5.1, 80].map(roundStep)).toEqual([1, 1, 2, 5, 10, 100]);
    expect(ticksBetween(-250, 400, 200)).toEqual([-200, 0, 200, 400].map((tick) => tick + 0));
  });
});

describe('what is in sight', () => {
  const view = { from: first!.start, px: 10, width: 100 };

  test('is placed from the left, rounded to hundredths of a pixel', () => {
    expect(xOf(view, first!.start)).toBe(0);
    expect(xOf(view, first!.start + 1 / 3)).toBe(3.33);
    expect(xOf(view, first!.start - 1)).toBe(-10);
  });

  test('is what reaches into it', () => {
    const { from } = view;
    expect(isInSight(view, from - 1, from + 0.1)).toBe(true);
    expect(isInSight(view, from - 1, from)).toBe(false);
    expect(isInSight(view, from + 9.9, from + 20)).toBe(true);
    expect(isInSight(view, from + 10, from + 20)).toBe(false);
    expect(charactersInSight(line, view).map(({ value }) => value)).toEqual([0x01]);
    expect(charactersInSight(line, { ...view, width: 101 }).map(({ value }) => value)).toEqual([0x01, 0xff]);
  });

  test('has bits from 1.2 pixels a bit on', () => {
    expect(showsBits({ from: 0, px: 1.2, width: 100 })).toBe(true);
    expect(showsBits({ from: 0, px: 1.19, width: 100 })).toBe(false);
  });

  test('has a nearest character: the one before a time, or behind it', () => {
    const near = (time: number) => characterNear(line, time)?.value;
    const gap = line.characters[1]!.end;
    expect([near(0), near(first!.start + 1), near(gap + 1), near(gap + 19), near(line.end)]).toEqual([
      0x01, 0x01, 0xff, 0x00, 0x55,
    ]);
  });
});

describe('the curve of a character', () => {
  const view = { from: first!.start, px: 10, width: 100 };

  test('goes down for the start bit and comes up for the stop bit', () => {
    // 01: start 0, then 1, then seven 0, then stop 1. Upper edge 0, track 34 high.
    expect(characterPath(view, first!, format, { key: 'ttl', inverted: false }, 0)).toBe('M0 0V34H10V0H20V34H90V0H100');
  });

  test('is upside down in an inverted track', () => {
    expect(characterPath(view, first!, format, { key: 'rs232', inverted: true }, 0)).toBe(
      'M0 34V0H10V34H20V0H90V34H100',
    );
  });
});
