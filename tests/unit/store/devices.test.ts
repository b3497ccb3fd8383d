import { describe, expect, it } from 'vitest';
import { builtInProfiles } from '../../../src/devices/index.ts';
import { Devices, Page } from '../../../src/store/index.ts';
import { pump } from '../devices/pump.ts';
import { rememberedIn, TestBrowser, TestWindow } from './window.ts';

const KEY = 'framewright.devices';

function devicesAt(browser = new TestBrowser()) {
  const window = new TestWindow();
  const page = new Page(window.bar, window.after);
  const storage = browser.tab();
  const devices = new Devices(page, storage, rememberedIn(storage));
  return { page, window, browser, storage, devices };
}

/** The devices of a browser that has a profile of a person. */
function withPump() {
  const browser = new TestBrowser();
  browser.texts.set(KEY, JSON.stringify({ format: 'framewright-devices', version: 1, profiles: [pump] }));
  return devicesAt(browser);
}

const namesIn = ({ own }: Devices) => own.value.map(({ name }) => name);

describe('the device', () => {
  const [first, second] = ['weg-drive', 's7-200'];

  it('is remembered when it is chosen by hand', () => {
    const { devices, browser } = devicesAt();
    devices.choose(first!);
    expect(devices.chosen.value?.id).toBe(first);
    expect(devicesAt(browser).devices.chosen.value?.id).toBe(first);
  });

  it('that a link names is spoken to, and not remembered', () => {
    const { page, devices, browser } = devicesAt();
    page.step({ ...page.draft.value, device: second });
    expect(devices.chosen.value?.id).toBe(second);
    expect(devicesAt(browser).devices.chosen.value).toBeUndefined();
    page.step({ ...page.draft.value, device: 'unknown' });
    expect(devices.chosen.value?.id).toBe(second);
  });

  it('takes what was typed with it along', () => {
    const { page, devices } = devicesAt();
    page.step({ ...page.draft.value, device: second });
    devices.choose(first!);
    expect(page.draft.value.device).toBe(first);
    devices.choose('');
    expect(page.draft.value.device).toBeUndefined();
    expect(devices.chosen.value).toBeUndefined();
  });

  it('is another tab’s own business', () => {
    const { devices, browser } = devicesAt();
    const other = devicesAt(browser).devices;
    devices.choose(first!);
    expect(other.chosen.value).toBeUndefined();
  });
});

describe('a change of a profile', () => {
  it('of a person replaces it, and is taken back', () => {
    const { devices } = withPump();
    expect(devices.keep(pump, { ...pump, source: 'other' })).toEqual({ kind: 'changed', before: pump });
    expect(devices.own.value).toMatchObject([{ id: 'pump', source: 'other' }]);
    expect(devices.undo()).toEqual(pump);
    expect(devices.own.value).toEqual([pump]);
    expect(devices.chosen.value).toBeUndefined();
    expect(devices.undo()).toBe('gone');
  });

  it('that is built in is in a copy, which is chosen, and deleted when it is taken back', () => {
    const { devices } = devicesAt();
    const [built] = builtInProfiles;
    const copied = devices.keep(built!, { ...built!, source: 'other' });
    expect(copied).toMatchObject({ kind: 'copied', before: built, copy: { name: `${built!.name} (2)` } });
    expect(devices.chosen.value?.id).toBe(`${built!.id} (2)`);
    expect(devices.undo()).toBe(built);
    expect(namesIn(devices)).toEqual([]);
    expect(devices.chosen.value?.id).toBe(built!.id);
  });

  it('creates profiles, deletes them and brings them back', () => {
    const { devices } = devicesAt();
    expect(devices.create('Fan')).toMatchObject({ name: 'Fan', registers: [] });
    const fan = devices.chosen.value!;
    expect([fan.name, devices.isOwn(fan)]).toEqual(['Fan', true]);
    devices.delete(fan);
    expect(namesIn(devices)).toEqual([]);
    expect(devices.chosenId.value).toBe('');
    expect(devices.undo()).toMatchObject({ name: 'Fan' });
    expect(namesIn(devices)).toEqual(['Fan']);
    expect(devices.chosen.value?.name).toBe('Fan');
  });

  it('that is not stored says why, and chooses nothing', () => {
    const { devices, browser } = withPump();
    browser.refuses = true;
    expect(devices.create('Fan')).toBe('refused');
    expect(devices.keep(pump, pump)).toBe('refused');
    expect(devices.delete(pump)).toBe('refused');
    browser.refuses = false;
    expect(devices.delete({ ...pump, id: 'other' })).toBe('gone');
    expect([devices.chosenId.value, devices.latest.value]).toEqual(['', undefined]);
  });

  it('can be taken back again if that is not stored', () => {
    const { devices, browser } = withPump();
    devices.delete(pump);
    browser.refuses = true;
    expect(devices.undo()).toBe('refused');
    browser.refuses = false;
    expect(devices.undo()).toEqual(pump);
  });
});

describe('a person’s own device in a link', () => {
  /** The address that a colleague gets. */
  function shared() {
    const { page, devices } = withPump();
    devices.choose(devices.own.value[0]!.id);
    return { page, devices, link: page.shared.value('') };
  }
  const openedBy = (link: string, browser = new TestBrowser()) => {
    const window = new TestWindow(link);
    const page = new Page(window.bar, window.after);
    const storage = browser.tab();
    return { page, window, browser, devices: new Devices(page, storage, rememberedIn(storage)) };
  };

  it('gives a colleague its names, and is not kept there', () => {
    const { devices, page, browser, window } = openedBy(shared().link);
    expect(devices.chosen.value).toMatchObject({ name: pump.name, registers: pump.registers });
    expect(devices.own.value).toEqual([]);
    expect(page.brokenLink.value).toBeUndefined();
    // A reload of what the address says by then brings it again.
    page.openTab('values');
    window.wait(1000);
    const again = openedBy(window.entries.at(-1)!, browser);
    expect(again.devices.chosen.value?.registers).toEqual(pump.registers);
    // Who chooses another one has links without it.
    again.devices.choose('weg-drive');
    expect(again.page.link.value).not.toContain('profile=');
    again.devices.choose(again.devices.linked.value!.id);
    expect(again.page.link.value).toContain('profile=');
  });

  it('is not in the person’s own address, and opened here it is the own device again', () => {
    const { page, devices, link } = shared();
    expect(page.link.value).not.toContain('profile=');
    const { browser } = withPump();
    const again = openedBy(link, browser);
    expect(again.devices.linked.value).toBeUndefined();
    expect(again.devices.chosen.value?.id).toBe(devices.own.value[0]!.id);
  });

  it('is another than a colleague’s own one of the same id', () => {
    const browser = new TestBrowser();
    const other = { ...pump, name: 'Other', registers: [] };
    browser.texts.set(KEY, JSON.stringify({ format: 'framewright-devices', version: 1, profiles: [other] }));
    const { devices } = openedBy(shared().link, browser);
    expect(devices.own.value[0]?.id).toBe(pump.id);
    expect(devices.chosen.value?.registers).toEqual(pump.registers);
    expect(devices.all.value.filter(({ id }) => id === devices.chosen.value?.id)).toHaveLength(1);
  });

  it('that is too large is told, and the link has its id alone', () => {
    const { page, devices } = devicesAt();
    const [register] = pump.registers;
    const registers = Array.from({ length: 300 }, (_, at) => ({
      ...register!,
      address: 10 * at,
      name: `Register ${at}`,
    }));
    const kept = devices.create('Large');
    if (typeof kept === 'string') throw new Error(kept);
    expect(page.leavesOut.value).toBe(false);
    devices.keep(kept, { ...kept, registers });
    expect(page.leavesOut.value).toBe(true);
    expect(page.shared.value('https://page/#x')).toBe('https://page/#x');
  });

  it('that cannot be read changes nothing', () => {
    const { devices } = openedBy('#rtu/request?v=4&unitId=6&functionCode=3&device=own~1&profile=%5B2%5D');
    expect(devices.chosen.value).toBeUndefined();
    expect(devices.linked.value).toBeUndefined();
  });
});
