import { describe, expect, it } from 'vitest';
import { builtInProfiles, type Profile, plainRegister } from '../../../../src/devices/index.ts';
import {
  addProfile,
  deleteProfile,
  profileCodec,
  profilesIn,
  replaceProfile,
  restoreProfile,
} from '../../../../src/workbench/devices/own-profiles.ts';
import { KeptList } from '../../../../src/workbench/kept-list.ts';
import { pump } from '../../devices/pump.ts';
import { storageOf } from '../memory-storage.ts';

const KEY = 'framewright.devices';

const fan: Profile = { ...pump, id: 'fan', name: 'Fan' };
const fileOf = (...profiles: readonly unknown[]) =>
  JSON.stringify({ format: 'framewright-devices', version: 2, profiles });

const listIn = (texts: Map<string, string>, room?: number) =>
  new KeptList('devices', profileCodec, () => storageOf(texts, room));
const listOf = (...profiles: readonly unknown[]) => listIn(new Map([[KEY, fileOf(...profiles)]]));
const namesIn = (list: ReturnType<typeof listIn>) => profilesIn(list).map(({ name }) => name);

describe('profiles out of the storage', () => {
  it('are all that can be read, and what cannot be used is named with its fault', () => {
    const broken = { ...pump, id: 'broken', name: 'Broken' };
    const register = pump.registers[0]!;
    for (const [bad, name, code] of [
      [{ ...broken, registers: [{ ...register, table: 'constructor' }] }, 'Broken', 'cell-unknown'],
      [{ ...broken, registers: [{ ...register, table: '__proto__' }] }, 'Broken', 'cell-unknown'],
      [{ ...broken, registers: [{ ...register, type: 'toString' }] }, 'Broken', 'cell-unknown'],
      [{ ...broken, registers: [null] }, 'Broken', 'not-a-row'],
      [{ ...broken, registers: 'none' }, 'Broken', 'setting-unreadable'],
      [{ ...broken, convention: 'constructor' }, 'Broken', 'setting-unreadable'],
      [{ ...broken, name: { toString: 1 } }, '', 'setting-unreadable'],
      [{ ...broken, traits: [{}] }, 'Broken', 'setting-unreadable'],
      [null, '', 'not-profiles'],
      [7, '', 'not-profiles'],
      [[], '', 'not-profiles'],
    ] as const) {
      const { kept } = listOf(pump, bad, fan);
      expect(kept.kind === 'list' && kept.items).toEqual([pump, fan]);
      expect(kept.kind === 'list' && kept.bad).toMatchObject([{ name, fault: { code } }]);
    }
  });

  it('keep what cannot be used as it is when others change', () => {
    const bad = { ...pump, id: 'bad', registers: [null], more: { deep: [1, 'x'] } };
    const texts = new Map([[KEY, fileOf(bad, pump)]]);
    const list = listIn(texts);
    addProfile(list, fan);
    expect(JSON.parse(texts.get(KEY) ?? '')).toEqual(JSON.parse(fileOf(pump, fan, bad)));
  });

  it('keep the meaning of what was stored in version 1, also of what cannot be used', () => {
    const tenths = {
      ...plainRegister,
      name: 'T',
      table: 'holding-register',
      address: 0,
      factor: 10,
      offset: 400,
    } as const;
    const bad = { ...pump, id: 'bad', registers: [null] };
    const old = { format: 'framewright-devices', version: 1, profiles: [{ ...pump, registers: [tenths] }, bad] };
    const texts = new Map([[KEY, JSON.stringify(old)]]);
    const list = listIn(texts);
    expect(profilesIn(list)[0]?.registers).toMatchObject([{ factor: 0.1, offset: -40 }]);
    addProfile(list, fan);
    expect(JSON.parse(texts.get(KEY) ?? '')).toMatchObject({
      version: 2,
      profiles: [{ registers: [{ factor: 0.1, offset: -40 }] }, { id: 'fan' }, { id: 'bad', version: 1 }],
    });
    expect(profilesIn(listIn(texts))[0]?.registers).toMatchObject([{ factor: 0.1, offset: -40 }]);
  });

  it('are unreadable as a whole if the text is not a list of profiles', () => {
    for (const [text, code] of [
      ['not ours', 'not-json'],
      ['{"profiles": []}', 'not-profiles'],
      [fileOf().replace('2', '3'), 'newer-version'],
      [fileOf().replace('[]', '{}'), 'not-profiles'],
      ['null', 'not-profiles'],
      ['[1]', 'not-profiles'],
    ] as const)
      expect(listIn(new Map([[KEY, text]])).kept).toMatchObject({ kind: 'unreadable', fault: { code }, text });
  });

  it('have ids and names of their own, whoever wrote the list', () => {
    const [first] = builtInProfiles;
    const twice = profilesIn(listOf(pump, pump, { ...pump, id: first!.id, name: first!.name }, { ...pump, id: '' }));
    expect(twice.map(({ id }) => id)).toEqual(['pump', 'pump (2)', `${first!.id} (2)`, 'own']);
    expect(new Set(twice.map(({ name }) => name)).size).toBe(4);
  });
});

describe('a profile of a person', () => {
  it('is added, replaced, deleted and brought back to its place', () => {
    const list = listOf(pump);
    expect(addProfile(list, pump)).toMatchObject({ id: 'pump (2)', name: 'Pump (2)' });
    expect(replaceProfile(list, { ...pump, name: 'Pump 7' })).toMatchObject({ name: 'Pump 7' });
    expect(namesIn(list)).toEqual(['Pump 7', 'Pump (2)']);
    const removed = deleteProfile(list, 'pump');
    expect(removed).toMatchObject({ index: 0 });
    expect(deleteProfile(list, 'pump')).toBe('gone');
    expect(replaceProfile(list, pump)).toBe('gone');
    if (typeof removed === 'string') throw new Error(removed);
    expect(restoreProfile(list, removed)).toMatchObject({ name: 'Pump 7' });
    expect(namesIn(list)).toEqual(['Pump 7', 'Pump (2)']);
  });
});
