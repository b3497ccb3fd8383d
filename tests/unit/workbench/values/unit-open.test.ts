import { describe, expect, it } from 'vitest';
import { builtInProfiles } from '../../../../src/devices/index.ts';
import {
  devicesWithUnit,
  evaluate,
  firstDraft,
  readScale,
  scaleOfFull,
  scaleWithUnit,
  typedFault,
  unitIn,
  valueInFrame,
  withText,
} from '../../../../src/workbench/index.ts';

/** Function 06 at P0683, with a value as typed. */
function fieldWith(value: string) {
  const draft = withText(firstDraft, 'value', value);
  const evaluation = evaluate(draft);
  const control = evaluation.controls.find(({ path }) => path === 'value')!;
  return { control, draft, evaluation };
}

const nothing = { device: undefined, own: undefined };

describe('a value in a unit that nothing here knows', () => {
  it('is told from a mistyped number', () => {
    expect(['45 Hz', '45Hz', '-4.5 °C', '20%', '3 x', '1,5 m³/h'].map(unitIn)).toEqual([
      'Hz',
      'Hz',
      '°C',
      '%',
      'x',
      'm³/h',
    ]);
    expect(['45', '12x', '0x1F', 'abc', '1 2', '45 Hz 3', '10h', '3A', '3A0', '3FF'].map(unitIn)).toEqual(
      Array(10).fill(undefined),
    );
    expect(typedFault('45 Hz', fieldWith('45 Hz'), nothing)).toEqual({ code: 'unit', typed: '45 Hz', unit: 'Hz' });
    expect(typedFault('45Hz', fieldWith('45Hz'), nothing)).toEqual({ code: 'unit', typed: '45Hz', unit: 'Hz' });
    expect(typedFault('12x', fieldWith('12x'), nothing)).toBeUndefined();
    // A scale of one's own in Hz says nothing of percent; a device that has Hz there does.
    const own = scaleWithUnit(scaleOfFull('60', '8192', 'Hz')!);
    const percent = fieldWith('45 %');
    expect(typedFault('45 %', percent, { device: undefined, own })).toMatchObject({ code: 'unit', unit: '%' });
    const drive = builtInProfiles.find(({ id }) => id === 'weg-drive');
    expect(typedFault('45 %', percent, { device: drive, own: undefined })).toMatchObject({ code: 'fault' });
  });

  it('gets its number by what full scale is: 60 Hz are 8192, so that 45 Hz are 6144', () => {
    const own = scaleWithUnit(scaleOfFull('60', '8192', 'Hz')!);
    expect(valueInFrame('45 Hz', fieldWith('45 Hz'), { device: undefined, own })).toBe('6144');
    expect(scaleOfFull('2.5', '0x4000', 'bar')?.factor).toBe('2.5/0x4000');
    expect(readScale(scaleOfFull('2.5', '0x4000', 'bar')!).faults.size).toBe(0);
  });

  it('gets none by a full scale that is not one', () => {
    for (const [full, raw] of [
      ['0', '8192'],
      ['60', '0'],
      ['60', '70000'],
      ['-60', '8192'],
      ['', '8192'],
      ['60', 'x'],
    ] as const)
      expect(scaleOfFull(full, raw, 'Hz')).toBeUndefined();
  });

  it('is known to devices, those first that have it where it is written', () => {
    const ids = (unit: string, first: number) =>
      devicesWithUnit(builtInProfiles, unit, { table: 'holding-register', first }).map(({ id }) => id);
    // P0683 of the WEG drive is its speed, in Hz.
    expect(ids('Hz', 683)[0]).toBe('weg-drive');
    expect(ids('hz', 683)).toEqual(ids('Hz', 683));
    expect(ids('parsec', 683)).toEqual([]);
  });
});
