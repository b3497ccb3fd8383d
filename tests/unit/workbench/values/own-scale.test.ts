import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { fraction, toNumber, unitsExactly } from '../../../../src/modbus/index.ts';
import { firstScale, readScale, scaleWithUnit, storedScale } from '../../../../src/workbench/values/own-scale.ts';

const drive = { ...firstScale, factor: '60/8192', unit: ' Hz ', least: '0', most: '60' };

describe('a scale as typed', () => {
  it('is exact: 8192 of raw are 60 Hz', () => {
    const { known, faults } = readScale(drive);
    expect([...faults]).toEqual([]);
    expect(known).toMatchObject({ unit: 'Hz', type: 'u16', order: 'ABCD' });
    expect(known?.scale).toMatchObject({
      factor: { numerator: 15n, denominator: 2048n },
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
    expect(storedScale({ version: 2, factor: '2' })).toEqual({ ...firstScale, factor: '2' });
    expect(storedScale(null)).toEqual(firstScale);
  });

  it('without a version is one of raw = value × factor + offset: the same raw number stands for the same value', () => {
    const old = storedScale({ factor: '8192/60', offset: '100', unit: 'Hz', least: '0', most: '60' });
    expect(old).toEqual({
      ...firstScale,
      factor: '15/2048',
      offset: '-0.732421875',
      unit: 'Hz',
      least: '0',
      most: '60',
    });
    const scale = scaleWithUnit(old)!.scale;
    // (4196 − 100) ÷ (8192/60) = 30.
    expect(toNumber(unitsExactly(fraction(4196), scale))).toBe(30);
    expect(storedScale({ factor: '3', unit: 'V' }).factor).toBe('1/3');
    expect(storedScale({ factor: '10', unit: 'V' }).factor).toBe('0.1');
  });

  it('is read back part by part', () => {
    const texts = {
      version: 2,
      factor: 'x',
      offset: '5',
      decimals: '99',
      unit: 'V',
      type: 'purple',
      order: 'constructor',
    };
    expect(storedScale(texts)).toEqual({ ...firstScale, offset: '5', unit: 'V' });
    expect(storedScale({ factor: '0' })).toEqual(firstScale);
    expect(storedScale({ least: '2', most: '1', unit: 'V' })).toEqual(firstScale);
  });

  it('comes out legal from any JSON, and comes back as it was', () => {
    const field = fc.oneof(fc.jsonValue(), fc.constantFrom('0', '1', '60/8192', 'x', '', 'u32', 'CDAB', 'f32'));
    const like = fc.record(Object.fromEntries(Object.keys(firstScale).map((name) => [name, field])));
    fc.assert(
      fc.property(fc.oneof(like, fc.jsonValue()), (stored) => {
        const texts = storedScale(JSON.parse(JSON.stringify(stored)));
        expect(readScale(texts).known).toBeDefined();
        expect(storedScale(JSON.parse(JSON.stringify(texts)))).toEqual(texts);
      }),
    );
  });
});
