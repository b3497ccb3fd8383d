import { signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import { Line } from '../../../src/store/index.ts';
import type { DeviceLine } from '../../../src/workbench/index.ts';
import { linePage, TestBrowser } from './window.ts';

const FIRST = { baud: 19_200, dataBits: 8, parity: 'even', stopBits: 1 } as const;
const DRIVE_LINE = { baud: 9600, dataBits: 8, parity: 'none', stopBits: 1 } as const;
const METER_LINE = { baud: 4800, dataBits: 8, parity: 'odd', stopBits: 1 } as const;
const DRIVE: DeviceLine = { id: 'drive', name: 'Drive', serial: { ...DRIVE_LINE } };
const METER: DeviceLine = { id: 'meter', name: 'Meter', serial: { ...METER_LINE } };

function lineIn(browser = new TestBrowser(), chosen?: DeviceLine) {
  const device = signal(chosen);
  const connected = signal(false);
  const page = linePage();
  return { browser, page, device, connected, line: new Line(page, browser.tab(), device, connected) };
}

describe('the line', () => {
  it('is that of the specification at first, and is kept for the next tab', () => {
    const { browser, line } = lineIn();
    const other = lineIn(browser).line;
    expect(line.setting.value).toEqual(FIRST);
    line.set({ baud: 38_400 });
    line.set({ parity: 'none', stopBits: 2 });
    const set = { baud: 38_400, dataBits: 8, parity: 'none', stopBits: 2 };
    expect(line.setting.value).toEqual(set);
    expect(other.setting.value).toEqual(FIRST);
    expect(lineIn(browser).line.setting.value).toEqual(set);
  });

  it('is at once that of a device that is chosen, until something is set by hand', () => {
    const { browser, line, device } = lineIn();
    device.value = DRIVE;
    expect(line.setting.value).toEqual(DRIVE_LINE);
    expect(line.own.value).toEqual({ name: 'Drive', serial: DRIVE_LINE });
    expect(line.isOwn.value).toBe(true);
    line.set({ baud: 57_600 });
    expect(line.setting.value).toEqual({ ...DRIVE_LINE, baud: 57_600 });
    expect(line.isOwn.value).toBe(false);
    expect(lineIn(browser, DRIVE).line.setting.value.baud).toBe(57_600);
    line.useOwn();
    expect(line.setting.value).toEqual(DRIVE_LINE);
    device.value = METER;
    expect(line.setting.value).toEqual(METER_LINE);
  });

  it('stays as it was set last for a device that has no line of its own', () => {
    const { line, device } = lineIn();
    line.set({ baud: 1200 });
    device.value = { id: 'plain', name: 'Plain' };
    expect(line.setting.value.baud).toBe(1200);
    expect(line.own.value).toBeUndefined();
    line.useOwn();
    expect(line.setting.value.baud).toBe(1200);
  });

  it('stays while it is in use, whatever device is chosen, and follows once it is free', () => {
    const { line, device, connected } = lineIn(undefined, DRIVE);
    expect(line.use()).toEqual(DRIVE_LINE);
    connected.value = true;
    device.value = METER;
    expect(line.setting.value).toEqual(DRIVE_LINE);
    expect(line.own.value).toEqual({ name: 'Meter', serial: METER_LINE });
    connected.value = false;
    expect(line.setting.value).toEqual(METER_LINE);
  });

  it('is the one that a link names, for the device of the link, also before that device has come', () => {
    const { line, device } = lineIn(undefined, { id: 'drive', name: '' });
    line.set({ baud: 115_200 });
    device.value = DRIVE;
    expect(line.setting.value).toEqual({ ...FIRST, baud: 115_200 });
    line.set(METER_LINE, 'meter');
    device.value = METER;
    expect(line.setting.value).toEqual(METER_LINE);
  });

  it('that is set by hand is in the frame’s link, and what a link names is set', () => {
    const { line, page, device } = lineIn();
    expect(page.line.value).toBeUndefined();
    line.set({ baud: 38_400 });
    expect(page.line.value).toEqual({ ...FIRST, baud: 38_400 });
    page.line.value = DRIVE_LINE;
    expect(line.setting.value).toEqual(DRIVE_LINE);
    device.value = METER;
    expect(page.line.value).toEqual(METER_LINE);
  });
});
