import { signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import { builtInProfiles, type Profile } from '../../../src/devices/index.ts';
import { Values } from '../../../src/store/index.ts';
import { TestBrowser } from './window.ts';

const drive = builtInProfiles.find(({ serial }) => serial !== undefined)!;
const device = signal<Profile | undefined>(undefined);

describe('the scale', () => {
  it('gives its unit to the values that are typed, in every tab', () => {
    const browser = new TestBrowser();
    const [mine, theirs] = [new Values(browser.tab(), device), new Values(browser.tab(), device)];
    expect(mine.units.value.own).toBeUndefined();
    theirs.setScale({ unit: 'Hz' });
    theirs.setScale({ factor: '60/8192' });
    expect(mine.scale.value).toMatchObject({ unit: 'Hz', factor: '60/8192', type: 'u16' });
    expect(mine.units.value.own?.unit).toBe('Hz');
    expect(new Values(browser.tab(), device).units.value.own?.unit).toBe('Hz');
  });

  it('stays as typed while it is not a scale, and gives no unit', () => {
    const values = new Values(new TestBrowser().tab(), device);
    values.setScale({ unit: 'Hz', factor: '0' });
    expect(values.scale.value.factor).toBe('0');
    expect(values.units.value.own).toBeUndefined();
  });

  it('comes after the units of the device', () => {
    const values = new Values(new TestBrowser().tab(), device);
    device.value = drive;
    expect(values.units.value.device).toBe(drive);
    device.value = undefined;
    expect(values.units.value.device).toBeUndefined();
  });
});
