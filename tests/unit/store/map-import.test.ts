import { signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import { type Profile, writeProfiles } from '../../../src/devices/index.ts';
import { type DeviceDesk, MapImport } from '../../../src/store/map-import.ts';
import { writeProfileFile } from '../../../src/workbench/index.ts';
import { pump } from '../devices/pump.ts';

const fan: Profile = { ...pump, id: 'fan', name: 'Fan' };
const ASKS = 'name;table;address;type;factor\nFlow;input;7;f32;0,5\nOdd;holding;many\nFlow;input;9\n';

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
  const take = (content: string, name = 'Pasted') => new MapImport(desk).take({ name, content });
  return { desk, own, chosen, take, names: () => own.value.map(({ name }) => name) };
}

describe('a map that is taken', () => {
  it.each(['csv', 'json'] as const)('is kept at once if it is our own %s', (ending) => {
    const { take, own } = importInto([]);
    expect(take(writeProfileFile(pump, ending))).toMatchObject([{ kind: 'kept', wanted: 'Pump' }]);
    expect(own.value).toMatchObject([{ name: 'Pump', registers: pump.registers }]);
  });

  it('is there already if nothing in it has changed', () => {
    const { take, chosen, names } = importInto([pump]);
    expect(take(writeProfileFile(pump, 'csv'))).toMatchObject([{ kind: 'here', profile: pump }]);
    expect(chosen).toEqual(['pump']);
    expect(names()).toEqual(['Pump']);
  });

  it('may be several', () => {
    const { take, names } = importInto([pump]);
    expect(take(writeProfiles([pump, fan]))).toMatchObject([{ kind: 'here' }, { kind: 'kept', wanted: 'Fan' }]);
    expect(names()).toEqual(['Pump', 'Fan']);
  });

  it('stays open where something is asked, lost, or of a name that is there', () => {
    const { desk, names } = importInto([pump]);
    for (const content of [ASKS, writeProfileFile({ ...pump, source: 'other' }, 'json'), 'hello', '']) {
      const mapImport = new MapImport(desk);
      expect(mapImport.take({ name: 'Pasted', content })).toEqual([]);
      expect(mapImport.source.value).toMatchObject({ content });
    }
    expect(names()).toEqual(['Pump']);
  });

  it('of several stops at the first that asks, and goes on behind it', () => {
    const { desk, names } = importInto([pump]);
    const mapImport = new MapImport(desk);
    const content = writeProfiles([fan, { ...pump, source: 'other' }, { ...fan, name: 'Mill' }]);
    expect(mapImport.take({ name: 'all.json', content })).toMatchObject([{ wanted: 'Fan' }]);
    expect(mapImport.known.value).toMatchObject({ name: 'Pump' });
    mapImport.keep('add');
    expect(mapImport.reading.value?.profile.name).toBe('Mill');
    mapImport.keep('add');
    expect(mapImport.source.value).toBeUndefined();
    expect(names()).toEqual(['Pump', 'Fan', 'Pump (2)', 'Mill']);
  });

  it('says why it is not kept', () => {
    expect(importInto([], 0).take(writeProfileFile(pump, 'csv'))).toBe('full');
  });
});

describe('a map that asks', () => {
  it('is kept with what was answered, and brought up to date by its name', () => {
    const { desk, own } = importInto([]);
    const mapImport = new MapImport(desk);
    mapImport.open({ name: 'Mill.csv', content: ASKS });
    expect(mapImport.questions.value.map(({ code }) => code)).toContain('counting');
    mapImport.answer('counting', 'one');
    mapImport.keep('add');
    expect(own.value).toMatchObject([{ name: 'Mill', answers: { counting: 'one' } }]);
    expect(own.value[0]?.registers.map(({ address }) => address)).toEqual([6, 8]);

    mapImport.open({ name: 'Mill.csv', content: ASKS.replace('Flow;input;7', 'Rate;input;7') });
    expect(mapImport.answers.value).toEqual({ counting: 'one' });
    mapImport.keep('update');
    expect(own.value[0]?.registers.map(({ name }) => name)).toEqual(['Rate', 'Flow']);
  });
});
