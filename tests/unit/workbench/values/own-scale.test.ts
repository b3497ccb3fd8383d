import { describe, expect, it } from 'vitest';
import { firstScale, readScale, scaleWithUnit, storedScale } from '../../../../src/workbench/values/own-scale.ts';

const drive = { ...firstScale, factor: '8192/60', unit: ' Hz ', least: '0', most: '60' };

describe('a scale as typed', () => {
  it('is exact: 8192 of raw are 60 Hz', () => {
    const { known, faults } = readScale(drive);
    expect([...faults]).toEqual([]);
    expect(known).toMatchObject({ unit: 'Hz', type: 'u16', order: 'ABCD' });
    expect(known?.scale).toMatchObject({
      factor: { numerator: 2048n, denominator: 15n },
      decimals: 1,
      most: { numerator: 60n, denominator: 1n },
    });
  });

  it('has its limits in order; equal ones are legal', () => {
    const faults = (least: string, most: string) => [...readScale({ ...drive, least, most }).faults];
    expect(faults('60', '0')).toEqual(['limits']);
    expect(faults('0', '0')).toEqual([]);
    expect(faults('-1', '0')).toEqual([]);
    expect(faults('0.30', '3/10')).toEqual([]);
    expect(faults('', '-5')).toEqual([]);
    expect(faults('x', '0')).toEqual(['least']);
  });

  it('says each text that is not a number, and a factor of 0', () => {
    const texts = { ...drive, factor: '0', offset: 'a', decimals: '13', most: 'b' };
    expect([...readScale(texts).faults].sort()).toEqual(['decimals', 'factor', 'most', 'offset']);
    expect(readScale(texts).known).toBeUndefined();
  });

  it('can be typed if it has a unit', () => {
    expect(scaleWithUnit(drive)?.unit).toBe('Hz');
    expect(scaleWithUnit({ ...drive, unit: ' ' })).toBeUndefined();
    expect(scaleWithUnit({ ...drive, factor: '0' })).toBeUndefined();
  });
});

describe('a scale as stored', () => {
  it('has what an older page did not store', () => {
    expect(storedScale({ factor: '2' })).toEqual({ ...firstScale, factor: '2' });
    expect(storedScale(null)).toEqual(firstScale);
  });

  it('is not taken with a type or an order that there is not', () => {
    expect(storedScale({ type: 'u17' })).toBeUndefined();
    expect(storedScale({ order: 'constructor' })).toBeUndefined();
    expect(storedScale({ unit: 7 })).toBeUndefined();
  });
});
