import { effect } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import { builtInSequences, newSequence, newStep, type SequenceTexts } from '../../../src/sequences/index.ts';
import { PageStorage, Sequences } from '../../../src/store/index.ts';
import { storageOf } from '../workbench/memory-storage.ts';

const KEY = 'framewright.sequences';
const fileOf = (...sequences: readonly unknown[]) =>
  JSON.stringify({ format: 'framewright-sequences', version: 1, sequences });
const pump = { name: 'Pump', about: '', transport: 'rtu', steps: [{ kind: 'wait', duration: 7 }], finally: [] };

function sequencesOn(texts: Map<string, string>, room?: number) {
  let told: (key: string) => void = () => {};
  const storage = new PageStorage(
    () => storageOf(texts, room),
    (listener) => {
      told = listener;
    },
  );
  const sequences = new Sequences(storage);
  return { sequences, told, names: () => sequences.custom.value.map(({ name }) => name) };
}
const stored = (texts: Map<string, string>) =>
  (JSON.parse(texts.get(KEY) ?? '{"sequences":[]}') as { sequences: readonly unknown[] }).sequences;
const withAbout = (sequence: SequenceTexts, about: string): SequenceTexts => ({ ...sequence, about });

describe('sequences out of the storage', () => {
  it('are those that can be read; the others are named with their faults, and stay as they are', () => {
    const bad = [
      { ...pump, name: 'Jump', steps: [{ kind: 'jump' }] },
      { ...pump, name: 'Object', steps: [{ kind: 'constructor' }] },
      { ...pump, name: 'Field', steps: [{ kind: 'wait', toString: 1 }] },
      { ...pump, name: 'Mode', transport: '__proto__' },
      { ...pump, name: 'List', steps: { length: 3 } },
      null,
      7,
    ];
    const texts = new Map([[KEY, fileOf(...bad.slice(0, 3), pump, ...bad.slice(3))]]);
    const { sequences, names } = sequencesOn(texts);
    expect(names()).toEqual(['Pump']);
    expect(sequences.notKept.value).toBeUndefined();
    expect(sequences.bad.value.map(({ number, faults: [fault] }) => [number, fault?.code])).toEqual([
      [1, 'not-a-step'],
      [2, 'not-a-step'],
      [3, 'field-unknown'],
      [5, 'not-a-transport'],
      [6, 'not-a-list'],
      [7, 'no-name'],
      [8, 'no-name'],
    ]);
    sequences.create('New');
    expect(stored(texts)).toEqual([pump, expect.objectContaining({ name: 'New' }), ...bad]);
    expect(sequencesOn(texts).names()).toEqual(['Pump', 'New']);
  });

  it('have names of their own, whoever wrote the list', () => {
    const [first] = builtInSequences;
    const { names } = sequencesOn(new Map([[KEY, fileOf(pump, pump, { ...pump, name: first!.name })]]));
    expect(names()).toEqual(['Pump', 'Pump (2)', `${first!.name} (2)`]);
  });

  it('are left alone if they are of a newer page, and changes last as long as the page', () => {
    const newer = fileOf().replace('1', '2');
    const texts = new Map([[KEY, newer]]);
    const { sequences, names } = sequencesOn(texts);
    expect(sequences.notKept.value).toBe('unreadable');
    sequences.create('New');
    sequences.create('New');
    expect(names()).toEqual(['New', 'New (2)']);
    expect(sequences.notKept.value).toBe('unreadable');
    expect(texts.get(KEY)).toBe(newer);
  });
});

describe('sequences', () => {
  it('shows the one that is chosen, or the first', () => {
    const { sequences } = sequencesOn(new Map([[KEY, fileOf(pump)]]));
    const seen: (string | undefined)[] = [];
    effect(() => void seen.push(sequences.current.value?.name));
    const first = builtInSequences[0]!.name;
    sequences.choose('Pump');
    sequences.choose('gone');
    expect(seen).toEqual([first, 'Pump', first]);
  });

  it('shows the one that was chosen last', () => {
    const texts = new Map([[KEY, fileOf(pump)]]);
    sequencesOn(texts).sequences.choose('Pump');
    expect(sequencesOn(texts).sequences.current.value?.name).toBe('Pump');
  });

  it('changes one of its own in place, and one that is built in as a copy', () => {
    const texts = new Map([[KEY, fileOf(pump)]]);
    const { sequences, names } = sequencesOn(texts);
    const [first] = builtInSequences;
    expect(sequences.edit(withAbout(first!, 'mine'), 'about')).toBe(`${first!.name} (2)`);
    expect(names()).toEqual(['Pump', `${first!.name} (2)`]);
    sequences.choose('Pump');
    expect(sequences.edit({ ...sequences.current.value!, name: first!.name }, '')).toBe(`${first!.name} (3)`);
    expect(names()).toEqual([`${first!.name} (3)`, `${first!.name} (2)`]);
    expect(sequencesOn(texts).names()).toEqual(names());
  });

  it('takes nothing that could not be read again', () => {
    const { sequences } = sequencesOn(new Map());
    sequences.create('Long');
    const steps = Array.from({ length: 501 }, () => newStep('wait'));
    expect(sequences.edit({ ...sequences.current.value!, steps }, '')).toBeUndefined();
    expect(sequences.current.value?.steps).toHaveLength(0);
  });

  it('undoes step by step; what is typed into one field is one step', () => {
    const { sequences, names } = sequencesOn(new Map());
    sequences.create('New');
    for (const about of ['a', 'ab', 'abc']) sequences.edit(withAbout(sequences.current.value!, about), 'about');
    sequences.edit({ ...sequences.current.value!, transport: 'ascii' }, '');
    sequences.deleteChosen();
    expect(names()).toEqual([]);
    sequences.undo();
    expect(sequences.current.value).toMatchObject({ name: 'New', about: 'abc', transport: 'ascii' });
    sequences.undo();
    expect(sequences.current.value).toMatchObject({ about: 'abc', transport: 'rtu' });
    sequences.undo();
    expect(sequences.current.value).toMatchObject({ name: 'New', about: '' });
    expect(sequences.canUndo.value).toBe(true);
    sequences.undo();
    expect([names(), sequences.current.value, sequences.canUndo.value]).toEqual([[], builtInSequences[0], false]);
    sequences.undo();
    expect(names()).toEqual([]);
  });

  it('goes on when the storage is full, and stores all again once it is not', () => {
    const texts = new Map<string, string>();
    const { sequences, names } = sequencesOn(texts, 400);
    sequences.create('A');
    sequences.edit(withAbout(sequences.current.value!, 'x'.repeat(1000)), 'about');
    expect(sequences.notKept.value).toBe('full');
    expect(sequences.current.value?.about).toHaveLength(1000);
    expect(stored(texts)).toMatchObject([{ name: 'A', about: '' }]);
    sequences.edit(withAbout(sequences.current.value!, 'short'), 'about');
    expect(sequences.notKept.value).toBeUndefined();
    expect(stored(texts)).toMatchObject([{ name: 'A', about: 'short' }]);
    expect(names()).toEqual(['A']);
  });

  it('follows what others store, and undoes nothing over it', () => {
    const texts = new Map<string, string>();
    const { sequences, told, names } = sequencesOn(texts);
    sequences.create('A');
    texts.set(KEY, fileOf(pump));
    told(KEY);
    expect([names(), sequences.canUndo.value]).toEqual([['Pump'], false]);
  });

  it('has the same sequence before and after it was stored', () => {
    const texts = new Map<string, string>();
    const { sequences } = sequencesOn(texts);
    const made = { ...newSequence('Made'), steps: [newStep('send', { bytes: '06 03' }), newStep('until')] };
    sequences.add(made);
    expect(sequencesOn(texts).sequences.custom.value).toEqual([made]);
  });
});

describe('a file of sequences', () => {
  it('adds what can be read, and says what became of each', () => {
    const { sequences, names } = sequencesOn(new Map());
    const odd = { ...pump, name: 'Odd', steps: [{ kind: 'jump' }] };
    expect(sequences.import(fileOf(pump, odd))).toMatchObject({
      kind: 'entries',
      entries: [
        { wanted: 'Pump', got: 'Pump' },
        { number: 2, name: 'Odd', faults: [{ code: 'not-a-step' }] },
      ],
    });
    expect(sequences.import(fileOf({ ...pump, about: 'another' }, pump))).toEqual({
      kind: 'entries',
      entries: [{ wanted: 'Pump', got: 'Pump (2)' }, { already: 'Pump' }],
    });
    expect([names(), sequences.current.value?.name]).toEqual([['Pump', 'Pump (2)'], 'Pump']);
  });

  it('takes the frame of a link, as it is typed into the page', () => {
    const { sequences } = sequencesOn(new Map());
    const link = 'rtu/request?unitId=6&functionCode=6&address=0x2AA&value=0';
    sequences.import(fileOf({ ...pump, steps: [{ kind: 'send', link }] }));
    // AP 6.6: register 682 of unit 6 becomes 0.
    expect(sequences.current.value?.steps[0]?.fields).toMatchObject({ bytes: '06 06 02 AA 00 00 A9 E5' });
  });

  it('says why nothing was added', () => {
    const { sequences, names } = sequencesOn(new Map());
    expect(sequences.import('x')).toMatchObject({ kind: 'unreadable', fault: { code: 'not-json' } });
    expect(sequences.import('{}')).toMatchObject({ kind: 'unreadable', fault: { code: 'not-sequences' } });
    expect(sequences.import(fileOf())).toEqual({ kind: 'entries', entries: [] });
    expect(names()).toEqual([]);
  });
});
