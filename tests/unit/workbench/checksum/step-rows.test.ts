import { describe, expect, it } from 'vitest';
import { readStepPlace, StepRows } from '../../../../src/workbench/checksum/step-rows.ts';

describe('the rows of the steps', () => {
  it('are nine a byte where all are unfolded: 2048 shifts of 256 bytes', () => {
    const rows = new StepRows(256, () => true);
    expect(rows.length).toBe(256 + 2048);
    expect(rows.place(0)).toEqual({ at: 0, shift: 0 });
    expect(rows.place(8)).toEqual({ at: 0, shift: 8 });
    expect(rows.place(9)).toEqual({ at: 1, shift: 0 });
    expect(rows.place(2303)).toEqual({ at: 255, shift: 8 });
  });

  it('are one a byte where all are folded', () => {
    const rows = new StepRows(3, () => false);
    expect(rows.length).toBe(3);
    expect(rows.place(2)).toEqual({ at: 2, shift: 0 });
    // A shift that is folded away is at its byte.
    expect(rows.row({ at: 1, shift: 5 })).toBe(1);
  });

  it('have a place each, and a row for each place, however they are folded', () => {
    const rows = new StepRows(20, (at) => at % 3 === 1);
    for (let row = 0; row < rows.length; row++) expect(rows.row(rows.place(row))).toBe(row);
    // 20 bytes, of which 1, 4, …, 19 are unfolded.
    expect(rows.length).toBe(20 + 7 * 8);
    expect(rows.place(1)).toEqual({ at: 1, shift: 0 });
    expect(rows.place(10)).toEqual({ at: 2, shift: 0 });
  });
});

describe('the place to go to', () => {
  it.each([
    ['5', { at: 5, shift: 0 }],
    [' 0x0A ', { at: 10, shift: 0 }],
    ['0Ah.3', { at: 10, shift: 3 }],
    ['7.8', { at: 7, shift: 8 }],
    ['15.0', { at: 15, shift: 0 }],
  ])('%s', (text, place) => {
    expect(readStepPlace(text, 16)).toEqual(place);
  });

  it.each(['', '.', '5.', '.3', '16', '-1', '5.9', '5.3.1', 'five', '1e1', '0x'])('not %j', (text) => {
    expect(readStepPlace(text, 16)).toBeUndefined();
  });
});
