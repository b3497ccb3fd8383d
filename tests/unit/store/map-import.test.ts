import { signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import { type Profile, writeProfiles } from '../../../src/devices/index.ts';
import { type DeviceDesk, MapImport, type MapReader } from '../../../src/store/map-import.ts';
import { MapDesk, writeProfileFile } from '../../../src/workbench/index.ts';
import { pump } from '../devices/pump.ts';

const fan: Profile = { ...pump, id: 'fan', name: 'Fan' };
const ASKS = 'name;table;address;type;factor\nFlow;input;7;f32;0,5\nOdd;holding;many\nFlow;input;9\n';

/** Reads where it is called, as the worker does elsewhere; not what is named `lost`. */
const reader: MapReader = {
  open(source) {
    const desk = new MapDesk(source);
    return {
      read: async (answers) => (source.name === 'lost' ? undefined : desk.read(answers)),
      close: () => undefined,
    };
  },
};

/** Devices of a person with room for some, and an import into them. */
function importInto(given: readonly Profile[], room = 10) {
  const own = signal(given);
  const chosen: string[] = [];
  const desk: DeviceDesk = {
    own: own as DeviceDesk['own'],
    choose: (id) => void chosen.push(id),
    add: (profile) => {
      if (own.value.length >= room) return 'full';
      const taken = own.value.some(({ name }) => name === profile.name);
      const added = { ...profile, id: `own ${own.value.length}`, name: taken ? `${profile.name} (2)` : profile.name };
      own.value = [...own.value, added];
      return added;
    },
    keep: (before, after) => {
      own.value = own.value.map((one) => (one === before ? after : one));
      return { kind: 'changed', before };
    },
  };
  const take = (content: string, name = 'Pasted') => new MapImport(desk, reader).take({ name, content });
  return { desk, own, chosen, take, names: () => own.value.map(({ name }) => name) };
}

describe('a map that is taken', () => {
  it.each(['csv', 'json'] as const)('is kept at once if it is our own %s', async (ending) => {
    const { take, own } = importInto([]);
    expect(await take(writeProfileFile(pump, ending))).toMatchObject([{ kind: 'kept', wanted: 'Pump' }]);
    expect(own.value).toMatchObject([{ name: 'Pump', registers: pump.registers }]);
  });

  it('is there already if nothing in it has changed', async () => {
    const { take, chosen, names } = importInto([pump]);
    expect(await take(writeProfileFile(pump, 'csv'))).toMatchObject([{ kind: 'here', profile: pump }]);
    expect(chosen).toEqual(['pump']);
    expect(names()).toEqual(['Pump']);
  });

  it('may be several', async () => {
    const { take, names } = importInto([pump]);
    expect(await take(writeProfiles([pump, fan]))).toMatchObject([{ kind: 'here' }, { kind: 'kept', wanted: 'Fan' }]);
    expect(names()).toEqual(['Pump', 'Fan']);
  });

  it('stays open where something is asked, lost, or of a name that is there', async () => {
    const { desk, names } = importInto([pump]);
    for (const content of [ASKS, writeProfileFile({ ...pump, source: 'other' }, 'json'), 'hello', '']) {
      const mapImport = new MapImport(desk, reader);
      expect(await mapImport.take({ name: 'Pasted', content })).toEqual([]);
      expect(mapImport.source.value).toMatchObject({ content });
    }
    expect(names()).toEqual(['Pump']);
  });

  it('of several stops at the first that asks, and goes on behind it', async () => {
    const { desk, names } = importInto([pump]);
    const mapImport = new MapImport(desk, reader);
    const content = writeProfiles([fan, { ...pump, source: 'other' }, { ...fan, name: 'Mill' }]);
    expect(await mapImport.take({ name: 'all.json', content })).toMatchObject([{ wanted: 'Fan' }]);
    expect(mapImport.known.value).toMatchObject({ name: 'Pump' });
    await mapImport.keep('add');
    expect(mapImport.reading.value?.profile.name).toBe('Mill');
    await mapImport.keep('add');
    expect(mapImport.source.value).toBeUndefined();
    expect(names()).toEqual(['Pump', 'Fan', 'Pump (2)', 'Mill']);
  });

  it('says why it is not kept', async () => {
    expect(await importInto([], 0).take(writeProfileFile(pump, 'csv'))).toBe('full');
    expect(await importInto([]).take(ASKS, 'lost')).toBe('unread');
  });
});

describe('a map that asks', () => {
  it('is kept with what was answered, and brought up to date by its name', async () => {
    const { desk, own } = importInto([]);
    const mapImport = new MapImport(desk, reader);
    await mapImport.open({ name: 'Mill.csv', content: ASKS });
    expect(mapImport.questions.value.map(({ code }) => code)).toContain('counting');
    mapImport.answer('counting', 'one');
    await mapImport.keep('add');
    expect(own.value).toMatchObject([{ name: 'Mill', answers: { counting: 'one' } }]);
    expect(own.value[0]?.registers.map(({ address }) => address)).toEqual([6, 8]);

    await mapImport.open({ name: 'Mill.csv', content: ASKS.replace('Flow;input;7', 'Rate;input;7') });
    expect(mapImport.answers.value).toEqual({ counting: 'one' });
    await mapImport.keep('update');
    expect(own.value[0]?.registers.map(({ name }) => name)).toEqual(['Rate', 'Flow']);
  });

  it('is of the file that was opened last, however late another is read', async () => {
    const { desk } = importInto([]);
    const late = new Map<string, () => void>();
    const mapImport = new MapImport(desk, {
      open(source) {
        const { read, close } = reader.open(source);
        return { read: (answers) => new Promise((done) => late.set(source.name, () => done(read(answers)))), close };
      },
    });
    const opened = [mapImport.open({ name: 'A.csv', content: ASKS }), mapImport.open({ name: 'B.csv', content: ASKS })];
    for (const name of ['B.csv', 'A.csv']) late.get(name)?.();
    expect(await Promise.all(opened)).toEqual([true, true]);
    expect(mapImport.reading.value?.profile.name).toBe('B');
    const lost = new MapImport(desk, reader);
    expect(await lost.open({ name: 'lost', content: ASKS })).toBe(false);
    expect(lost.source.value).toBeUndefined();
  });
});
