import { signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import { builtInProfiles, type Profile } from '../../../src/devices/index.ts';
import { Line, Values } from '../../../src/store/index.ts';
import { TestBrowser } from './window.ts';

const drive = builtInProfiles.find(({ serial }) => serial !== undefined)!;
const device = signal<Profile | undefined>(undefined);

describe('the scale', () => {
  it('gives its unit to the values that are typed, in every tab', () => {
    const browser = new TestBrowser();
    const [mine, theirs] = [new Values(browser.tab(), device), new Values(browser.tab(), device)];
    expect(mine.units.value.own).toBeUndefined();
    theirs.setScale({ unit: 'Hz' });
    theirs.setScale({ factor: '8192/60' });
    expect(mine.scale.value).toMatchObject({ unit: 'Hz', factor: '8192/60', type: 'u16' });
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

describe('the line', () => {
  const set = { baud: 38_400, dataBits: 8, parity: 'none', stopBits: 2 } as const;

  it('is kept, with a format for each mode', () => {
    const browser = new TestBrowser();
    const line = new Line(browser.tab(), device);
    expect(line.choice('rtu').serial).toEqual({ baud: 19_200, dataBits: 8, parity: 'even', stopBits: 1 });
    line.set('rtu', { serial: set, delay: 7 });
    const again = new Line(browser.tab(), device);
    expect(again.choice('rtu')).toMatchObject({ serial: set, delay: 7, device: undefined });
    expect(again.choice('ascii').serial).toEqual({ baud: 38_400, dataBits: 7, parity: 'even', stopBits: 1 });
  });

  it('is that of a device once it is chosen, until something else is set', () => {
    const line = new Line(new TestBrowser().tab(), device);
    line.set('rtu', { serial: set });
    device.value = drive;
    expect(line.choice('rtu')).toMatchObject({ serial: drive.serial, device: drive.name });
    line.set('rtu', { serial: set });
    expect(line.choice('rtu')).toMatchObject({ serial: set, device: undefined });
    device.value = undefined;
  });
});
