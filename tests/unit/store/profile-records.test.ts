import { describe, expect, it } from 'vitest';
import { type Profile, plainRegister } from '../../../src/devices/index.ts';
import { ProfileRecords } from '../../../src/store/profile-records.ts';
import { addProfile, deleteProfile, replaceProfile, restoreProfile } from '../../../src/workbench/index.ts';
import { pump } from '../devices/pump.ts';
import { settle, TestRecords } from './test-records.ts';
import { TestBrowser } from './window.ts';

const KEY = 'framewright.devices';
const fan: Profile = { ...pump, id: 'fan', name: 'Fan' };
const valve: Profile = { ...pump, id: 'valve', name: 'Valve' };
const listText = (...profiles: readonly unknown[]) =>
  JSON.stringify({ format: 'framewright-devices', version: 2, profiles });

/** A browser with what earlier pages kept in their list, and tabs of today's page. */
class Browser {
  readonly texts = new TestBrowser();
  readonly records = new TestRecords();

  constructor(...listed: readonly unknown[]) {
    if (listed.length > 0) this.texts.texts.set(KEY, listText(...listed));
  }

  tab(before?: () => Promise<void>): ProfileRecords {
    return new ProfileRecords(this.records.tab(before), this.texts.tab(), '');
  }

  async settledTab(): Promise<ProfileRecords> {
    const tab = this.tab();
    await settle();
    return tab;
  }

  /** The names that a page has that is opened now. */
  async names(): Promise<readonly string[]> {
    return namesIn(await this.settledTab());
  }

  get list(): readonly string[] {
    const text = this.texts.texts.get(KEY);
    return text === undefined ? [] : JSON.parse(text).profiles.map(({ name }: Profile) => name);
  }
}

const namesIn = ({ items }: ProfileRecords) => items.value.map(({ name }) => name);
const added = (list: ProfileRecords, profile: Profile): Profile => {
  const outcome = addProfile(list, profile);
  if (typeof outcome === 'string') throw new Error(outcome);
  return outcome;
};

describe('profiles as records', () => {
  it('are there when the page is opened again, in their order, with all they have', async () => {
    const browser = new Browser();
    const tab = await browser.settledTab();
    const rich: Profile = {
      ...pump,
      serial: { baud: 9600, dataBits: 8, parity: 'even', stopBits: 1, unit: 7 },
      traits: ['any-value-is-on'],
      answers: { counting: 'one' },
      registers: [
        {
          ...plainRegister,
          name: 'T',
          table: 'input-register',
          access: 'r',
          address: 9,
          factor: 1000 / 123457,
          exact: { factor: '1000/123457', offset: '0' },
          scaleRegister: { address: 3 },
          notImplemented: '0x8000',
          mask: 0xff,
          names: [{ number: 1, name: 'on' }],
          group: 'G',
          models: ['A', 'B'],
        },
      ],
    };
    for (const profile of [rich, fan, valve]) added(tab, profile);
    await settle();
    expect((await browser.settledTab()).items.value).toEqual([rich, fan, valve]);
  });

  it('are written one by one, only what was changed', async () => {
    const browser = new Browser();
    const tab = await browser.settledTab();
    for (const profile of [pump, fan]) added(tab, profile);
    await settle();
    browser.records.written.length = 0;
    replaceProfile(tab, { ...fan, source: 'other' });
    await settle();
    expect(browser.records.written).toEqual([expect.stringMatching(/^fan /)]);
    deleteProfile(tab, 'pump');
    await settle();
    expect(browser.records.written).toHaveLength(1);
    expect(await browser.names()).toEqual(['Fan']);
  });

  it('are written once more after a change while they are written, and not for each', async () => {
    const browser = new Browser();
    const tab = await browser.settledTab();
    added(tab, pump);
    await settle();
    browser.records.written.length = 0;
    for (const source of ['a', 'b', 'c', 'd']) replaceProfile(tab, { ...pump, source });
    await settle();
    expect(browser.records.written).toHaveLength(2);
    expect((await browser.settledTab()).items.value).toMatchObject([{ source: 'd' }]);
  });

  it('come back to their place after they were deleted', async () => {
    const browser = new Browser();
    const tab = await browser.settledTab();
    for (const profile of [pump, fan, valve]) added(tab, profile);
    for (const id of ['fan', 'pump', 'valve']) {
      const before = namesIn(tab);
      const removed = deleteProfile(tab, id);
      if (typeof removed === 'string') throw new Error(removed);
      await settle();
      expect(await browser.names()).toEqual(before.filter((name) => name !== removed.item.name));
      restoreProfile(tab, removed);
      await settle();
      expect(namesIn(tab)).toEqual(before);
      expect(await browser.names()).toEqual(before);
    }
  });

  it('say what is gone', async () => {
    const tab = await new Browser().settledTab();
    expect(replaceProfile(tab, pump)).toBe('gone');
    expect(deleteProfile(tab, 'pump')).toBe('gone');
  });

  it('that are wanted come first', async () => {
    const browser = new Browser();
    const tab = await browser.settledTab();
    for (const profile of [pump, fan, valve]) added(tab, profile);
    await settle();
    const asked: string[] = [];
    const storage = browser.records.tab();
    const records = new ProfileRecords(
      {
        ...storage,
        get: (key) => {
          asked.push(key.split(' ')[0]!);
          return storage.get(key);
        },
      },
      browser.texts.tab(),
      'valve',
    );
    expect(records.loaded.value).toBe(false);
    await settle();
    expect(asked).toEqual(['valve', 'pump', 'fan']);
    expect(records.loaded.value).toBe(true);
    expect(namesIn(records)).toEqual(['Pump', 'Fan', 'Valve']);
  });

  it('that are added before the others have come lose none, and have ids and names of their own', async () => {
    const browser = new Browser();
    added(await browser.settledTab(), pump);
    await settle();
    const tab = browser.tab();
    added(tab, { ...pump, source: 'other' });
    await settle();
    expect(new Set(tab.items.value.map(({ id }) => id))).toEqual(new Set(['pump', 'pump (2)']));
    expect(await browser.names()).toEqual(['Pump', 'Pump (2)']);
    expect((await browser.settledTab()).items.value.map(({ source }) => source)).toEqual(['manual', 'other']);
  });
});

describe('another tab', () => {
  it('learns of what is added, changed and deleted', async () => {
    const browser = new Browser();
    const [one, other] = [await browser.settledTab(), await browser.settledTab()];
    added(one, pump);
    added(other, fan);
    await settle();
    expect(namesIn(one)).toEqual(namesIn(other).toReversed());
    replaceProfile(one, { ...pump, name: 'Pump 7' });
    await settle();
    expect(namesIn(other)).toContain('Pump 7');
    deleteProfile(other, 'pump');
    await settle();
    expect(namesIn(one)).toEqual(['Fan']);
  });

  it('adds a profile of the same id at the same time, and both are kept', async () => {
    const browser = new Browser();
    const [one, other] = [await browser.settledTab(), await browser.settledTab()];
    added(one, pump);
    added(other, { ...pump, source: 'other' });
    await settle();
    for (const tab of [one, other, await browser.settledTab()])
      expect(new Set(tab.items.value.map(({ source }) => source))).toEqual(new Set(['manual', 'other']));
  });
});

describe('a record that cannot be used', () => {
  it.each([
    [{ version: 2, place: 0, profile: { ...pump, registers: [null] } }, 'Pump', 'not-a-row'],
    [{ version: 2, place: 0, profile: { ...pump, convention: 'constructor' } }, 'Pump', 'setting-unreadable'],
    [{ version: 2, place: 0, profile: null }, '', 'not-profiles'],
    [{ version: 3, place: 0, profile: pump }, 'Pump', 'newer-version'],
    [{ version: 2, place: 0, profile: { ...pump, registers: 1n } }, 'Pump', 'not-json'],
    ['nonsense', '', 'not-profiles'],
    [7, '', 'not-profiles'],
  ])('is named, and stays as it is (%#)', async (record, name, code) => {
    const browser = new Browser();
    browser.records.records.set('odd', record);
    const tab = await browser.settledTab();
    expect(tab.stored.value).toMatchObject({ kind: 'list', items: [], bad: [{ name, fault: { code } }] });
    added(tab, fan);
    await settle();
    expect(browser.records.records.get('odd')).toEqual(record);
    expect(await browser.names()).toEqual(['Fan']);
  });

  it('of version 1 has its own meaning', async () => {
    const browser = new Browser();
    const registers = [{ ...pump.registers[0], factor: 10, offset: 400 }];
    browser.records.records.set('old', { version: 1, place: 0, profile: { ...pump, registers } });
    const tab = await browser.settledTab();
    expect(tab.items.value[0]?.registers).toMatchObject([{ factor: 0.1, offset: -40 }]);
  });
});

describe('a storage that does not keep', () => {
  it('is told, and what is changed lasts until the page is closed', async () => {
    const browser = new Browser();
    browser.records.refuses = true;
    const tab = await browser.settledTab();
    expect(tab.loaded.value).toBe(true);
    expect(tab.stored.value).toEqual({ kind: 'refused' });
    added(tab, pump);
    await settle();
    replaceProfile(tab, { ...pump, name: 'Pump 7' });
    await settle();
    expect(namesIn(tab)).toEqual(['Pump 7']);
    expect(tab.stored.value).toEqual({ kind: 'refused' });
  });

  it('is told when it is full, keeps what it had, and takes the rest when there is room', async () => {
    const browser = new Browser();
    const tab = await browser.settledTab();
    added(tab, pump);
    await settle();
    browser.records.room = 0;
    added(tab, fan);
    replaceProfile(tab, { ...pump, name: 'Pump 7' });
    await settle();
    expect(tab.stored.value).toEqual({ kind: 'full' });
    expect(namesIn(tab)).toEqual(['Pump 7', 'Fan']);
    expect(await browser.names()).toEqual(['Pump']);
    browser.records.room = 9;
    deleteProfile(tab, 'pump');
    await settle();
    expect(tab.stored.value.kind).toBe('list');
    expect(await browser.names()).toEqual(['Fan']);
  });

  it('has no part in what was deleted before it was written', async () => {
    const browser = new Browser();
    const tab = await browser.settledTab();
    browser.records.room = 0;
    added(tab, fan);
    await settle();
    deleteProfile(tab, 'fan');
    await settle();
    expect(tab.stored.value).toMatchObject({ kind: 'list', items: [] });
  });
});

describe('the list of an earlier page', () => {
  it('is there at once, is taken over, and is deleted then', async () => {
    const browser = new Browser(pump, fan);
    const tab = browser.tab();
    expect(namesIn(tab)).toEqual(['Pump', 'Fan']);
    expect(browser.texts.texts.has(KEY)).toBe(true);
    await settle();
    expect(browser.texts.texts.has(KEY)).toBe(false);
    expect(tab.items.value).toEqual([pump, fan]);
    expect((await browser.settledTab()).items.value).toEqual([pump, fan]);
  });

  it('of version 1 is taken over with the meaning that it had', async () => {
    const browser = new Browser();
    const registers = [{ ...pump.registers[0], factor: 10, offset: 400 }];
    browser.texts.texts.set(KEY, listText({ ...pump, registers }).replace('"version":2', '"version":1'));
    await browser.settledTab();
    expect(browser.list).toEqual([]);
    expect((await browser.settledTab()).items.value[0]?.registers).toMatchObject([{ factor: 0.1, offset: -40 }]);
  });

  it('keeps what of it cannot be read, which is told', async () => {
    const bad = { ...pump, id: 'bad', name: 'Bad', registers: [null] };
    const browser = new Browser(bad, fan);
    const tab = await browser.settledTab();
    expect(tab.stored.value).toMatchObject({ kind: 'list', items: [fan], bad: [{ name: 'Bad' }] });
    expect(browser.list).toEqual(['Bad']);
    browser.texts.texts.set(KEY, 'not ours');
    const other = await browser.settledTab();
    expect(other.stored.value).toMatchObject({ kind: 'unreadable', text: 'not ours' });
    expect(namesIn(other)).toEqual(['Fan']);
    expect(other.setUnreadableAside()).toEqual({ key: `${KEY}.unreadable-1` });
    expect(other.stored.value.kind).toBe('list');
  });

  it.each([0, 1, 2])('loses nothing and doubles nothing if it is interrupted after %i writes', async (writes) => {
    const browser = new Browser(pump, fan, valve);
    browser.records.room = writes;
    const tab = await browser.settledTab();
    expect(namesIn(tab)).toEqual(['Pump', 'Fan', 'Valve']);
    // What is still in the list lasts there: nothing is said.
    expect(tab.stored.value.kind).toBe('list');
    expect(browser.list).toEqual(['Pump', 'Fan', 'Valve'].slice(writes));
    browser.records.room = 9;
    expect(await browser.names()).toEqual(['Pump', 'Fan', 'Valve']);
    expect(browser.list).toEqual([]);
    expect(browser.records.records.size).toBe(3);
  });

  it('is not taken twice if the page ends between the record and the list', async () => {
    const browser = new Browser(pump, fan);
    const text = browser.texts.texts.get(KEY)!;
    await browser.settledTab();
    browser.texts.texts.set(KEY, text);
    expect(await browser.names()).toEqual(['Pump', 'Fan']);
    expect(browser.list).toEqual([]);
  });

  it('is not taken over the records of a person, of whatever id', async () => {
    const browser = new Browser(pump);
    const tab = await browser.settledTab();
    replaceProfile(tab, { ...pump, source: 'edited' });
    await settle();
    // A page of an earlier version has no list any more, and begins one.
    browser.texts.store(KEY, listText({ ...pump, source: 'earlier' }));
    await settle();
    expect(tab.items.value.map(({ source }) => source)).toEqual(['edited', 'earlier']);
    expect(browser.list).toEqual([]);
    expect(new Set((await browser.settledTab()).items.value.map(({ source }) => source))).toEqual(
      new Set(['edited', 'earlier']),
    );
  });

  it.each([false, true])('is taken by one of two tabs, and changes of both are kept (apart: %s)', async (apart) => {
    const browser = new Browser(pump, fan, valve);
    const slow = async () => void (apart && (await settle()));
    const [one, other] = [browser.tab(), browser.tab(slow)];
    replaceProfile(one, { ...pump, source: 'one' });
    replaceProfile(other, { ...fan, source: 'other' });
    deleteProfile(one, 'valve');
    for (let n = 0; n < 50; n++) await settle();
    for (const tab of [one, other, await browser.settledTab()])
      expect(tab.items.value.map(({ id, source }) => [id, source])).toEqual([
        ['pump', 'one'],
        ['fan', 'other'],
      ]);
    expect(browser.list).toEqual([]);
  });

  it('is changed here while it cannot be taken over', async () => {
    const browser = new Browser(pump, fan);
    browser.records.refuses = true;
    const tab = await browser.settledTab();
    expect(namesIn(tab)).toEqual(['Pump', 'Fan']);
    deleteProfile(tab, 'pump');
    await settle();
    expect(browser.list).toEqual(['Fan']);
  });
});
