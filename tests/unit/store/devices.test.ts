import { describe, expect, it } from 'vitest';
import { builtInProfiles } from '../../../src/devices/index.ts';
import { Devices, Page } from '../../../src/store/index.ts';
import { pump } from '../devices/pump.ts';
import { settle, TestRecords } from './test-records.ts';
import { rememberedIn, TestBrowser, TestWindow } from './window.ts';

const KEY = 'framewright.devices';

function devicesAt(browser = new TestBrowser(), records = new TestRecords(), hash = '') {
  const window = new TestWindow(hash);
  const page = new Page(window.bar, window.after);
  const storage = browser.tab();
  const devices = new Devices(page, storage, rememberedIn(storage), records.tab());
  return { page, window, browser, records, devices };
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
    expect(devices.undo()).toMatchObject({ profile: pump });
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
    expect(devices.undo()).toMatchObject({ profile: built });
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
    expect(devices.undo()).toMatchObject({ profile: { name: 'Fan' } });
    expect(namesIn(devices)).toEqual(['Fan']);
    expect(devices.chosen.value?.name).toBe('Fan');
  });

  it('is taken back step by step, and made again', () => {
    const { devices } = withPump();
    const sources = ['one', 'two', 'three'];
    const now = () => devices.own.value.map(({ source }) => source);
    for (const source of sources) devices.keep(devices.own.value[0]!, { ...pump, source });
    for (const source of ['two', 'one', pump.source]) {
      expect(devices.undo()).toMatchObject({ profile: { source } });
      expect(now()).toEqual([source]);
    }
    expect([devices.undo(), devices.history.latest.value]).toEqual(['gone', undefined]);
    for (const source of sources) {
      expect(devices.redo()).toMatchObject({ profile: { source } });
      expect(now()).toEqual([source]);
    }
    expect([devices.redo(), devices.history.next.value]).toEqual(['gone', undefined]);
    devices.undo();
    // What is changed now takes the place of what was taken back.
    devices.keep(devices.own.value[0]!, { ...pump, source: 'other' });
    expect([devices.redo(), now()]).toEqual(['gone', ['other']]);
    devices.undo();
    expect(now()).toEqual(['two']);
  });

  it('of several devices shows that of each step', () => {
    const { devices } = withPump();
    const [built] = builtInProfiles;
    devices.choose('pump');
    devices.keep(pump, { ...pump, source: 'other' });
    const copied = devices.keep(built!, { ...built!, source: 'other' });
    const copy = typeof copied !== 'string' && copied.kind === 'copied' ? copied.copy : undefined;
    devices.keep(copy!, { ...copy!, source: 'third' });
    devices.delete(devices.chosen.value!);
    const chosen = () => [devices.chosenId.value, devices.own.value.map(({ id, source }) => `${id}: ${source}`)];
    const states = [
      [copy!.id, ['pump: other', `${copy!.id}: third`]],
      [copy!.id, ['pump: other', `${copy!.id}: other`]],
      [built!.id, ['pump: other']],
      ['pump', [`pump: ${pump.source}`]],
    ];
    for (const state of states) {
      devices.undo();
      expect(chosen()).toEqual(state);
    }
    const again = [['pump', ['pump: other']], states[1], states[0], ['', ['pump: other']]];
    for (const state of again) {
      devices.redo();
      expect(chosen()).toEqual(state);
    }
    devices.undo();
    expect(chosen()).toEqual(states[0]);
  });

  it('that another tab has deleted says so, and chooses nothing', () => {
    const { devices } = withPump();
    expect(devices.delete({ ...pump, id: 'other' })).toBe('gone');
    expect(devices.keep(pump, { ...pump, id: 'other' })).toBe('gone');
    expect([devices.chosenId.value, devices.history.latest.value]).toEqual(['', undefined]);
  });

  it('lasts until the page is closed where it cannot be stored, and is taken back', async () => {
    const { devices, records } = withPump();
    records.refuses = true;
    await settle();
    expect(devices.create('Fan')).toMatchObject({ name: 'Fan' });
    devices.delete(pump);
    expect(namesIn(devices)).toEqual(['Fan']);
    expect(devices.undo()).toMatchObject({ profile: pump });
    await settle();
    expect(namesIn(devices)).toEqual(['Pump', 'Fan']);
    expect(devices.list.stored.value).toEqual({ kind: 'refused' });
  });
});

describe('a device that is stored', () => {
  /** A browser that has the pump, and its page, opened at an address, while its records have not come. */
  async function storedPump(hash = '', choice?: string) {
    const { browser, records, devices } = devicesAt();
    devices.add(pump);
    devices.choose(choice ?? '');
    await settle();
    return devicesAt(browser, records, hash);
  }
  const named = (id: string) => `#rtu/request?v=3&unitId=6&functionCode=3&device=${id}`;

  it('is waited for if it was chosen, and by nobody else', async () => {
    const { devices } = await storedPump('', 'pump');
    expect([devices.came.value, devices.chosen.value]).toEqual([false, undefined]);
    await settle();
    expect([devices.came.value, devices.chosen.value?.name]).toEqual([true, 'Pump']);
    for (const id of ['', 'weg-drive']) expect((await storedPump('', id)).devices.came.value).toBe(true);
  });

  it('is waited for if a link names it', async () => {
    const { devices } = await storedPump(named('pump'));
    expect([devices.came.value, devices.chosen.value]).toEqual([false, undefined]);
    await settle();
    expect([devices.came.value, devices.chosen.value?.name]).toEqual([true, 'Pump']);
    expect((await storedPump(named('weg-drive'))).devices.came.value).toBe(true);
  });

  it('is surely unknown when all have come', async () => {
    const { devices } = await storedPump(named('other'));
    expect(devices.came.value).toBe(false);
    await settle();
    expect([devices.came.value, devices.chosen.value]).toEqual([true, undefined]);
  });

  it('is its owner’s own in a link that has it', async () => {
    const { devices, page } = await storedPump('', 'pump');
    await settle();
    const { devices: again } = await storedPump(page.shared.value(''));
    expect([again.came.value, again.linked.value]).toEqual([false, undefined]);
    await settle();
    expect([devices.chosen.value, again.chosen.value]).toEqual([pump, pump]);
    expect(again.linked.value).toBeUndefined();
  });
});

describe('a person’s own device in a link', () => {
  /** The address that a colleague gets. */
  function shared() {
    const { page, devices } = withPump();
    devices.choose(devices.own.value[0]!.id);
    return { page, devices, link: page.shared.value('') };
  }
  const openedBy = async (link: string, browser = new TestBrowser()) => {
    const opened = devicesAt(browser, new TestRecords(), link);
    await settle();
    return opened;
  };

  it('gives a colleague its names, and is not kept there', async () => {
    const { devices, page, browser, window } = await openedBy(shared().link);
    expect(devices.chosen.value).toMatchObject({ name: pump.name, registers: pump.registers });
    expect(devices.own.value).toEqual([]);
    expect(page.brokenLink.value).toBeUndefined();
    // A reload of what the address says by then brings it again.
    page.openTab('values');
    window.wait(1000);
    const again = await openedBy(window.entries.at(-1)!, browser);
    expect(again.devices.chosen.value?.registers).toEqual(pump.registers);
    // Who chooses another one has links without it.
    again.devices.choose('weg-drive');
    expect(again.page.link.value).not.toContain('profile=');
    again.devices.choose(again.devices.linked.value!.id);
    expect(again.page.link.value).toContain('profile=');
  });

  it('is not in the person’s own address, and opened here it is the own device again', async () => {
    const { page, devices, link } = shared();
    expect(page.link.value).not.toContain('profile=');
    const { browser } = withPump();
    const again = await openedBy(link, browser);
    expect(again.devices.linked.value).toBeUndefined();
    expect(again.devices.chosen.value?.id).toBe(devices.own.value[0]!.id);
  });

  it('is another than a colleague’s own one of the same id', async () => {
    const browser = new TestBrowser();
    const other = { ...pump, name: 'Other', registers: [] };
    browser.texts.set(KEY, JSON.stringify({ format: 'framewright-devices', version: 1, profiles: [other] }));
    const { devices } = await openedBy(shared().link, browser);
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

  it('that cannot be read changes nothing', async () => {
    const { devices } = await openedBy('#rtu/request?v=4&unitId=6&functionCode=3&device=own~1&profile=%5B2%5D');
    expect(devices.chosen.value).toBeUndefined();
    expect(devices.linked.value).toBeUndefined();
  });
});
