import { describe, expect, it } from 'vitest';
import { builtInSequences, newSequence, newStep, type SequenceTexts } from '../../../../src/sequences/index.ts';
import { importSequences, type SequenceImportWords } from '../../../../src/workbench/bus/sequence-import.ts';
import { SequenceLibrary, sequenceCodec } from '../../../../src/workbench/bus/sequence-library.ts';
import { KeptList } from '../../../../src/workbench/kept-list.ts';
import { storageOf } from '../memory-storage.ts';

const KEY = 'framewright.sequences';
const fileOf = (...sequences: readonly unknown[]) =>
  JSON.stringify({ format: 'framewright-sequences', version: 1, sequences });
const pump = { name: 'Pump', about: '', transport: 'rtu', steps: [{ kind: 'wait', duration: 7 }], finally: [] };

function libraryOn(texts: Map<string, string>, room?: number) {
  const list = new KeptList('sequences', sequenceCodec, () => storageOf(texts, room));
  const chosen = { value: '' };
  const library = new SequenceLibrary(list, chosen);
  return { library, chosen, list, names: () => library.own.map(({ name }) => name) };
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
    const { library, names } = libraryOn(texts);
    expect(names()).toEqual(['Pump']);
    expect(library.notKept).toBeUndefined();
    expect(library.bad.map(({ number, faults: [fault] }) => [number, fault?.code])).toEqual([
      [1, 'not-a-step'],
      [2, 'not-a-step'],
      [3, 'field-unknown'],
      [5, 'not-a-transport'],
      [6, 'not-a-list'],
      [7, 'no-name'],
      [8, 'no-name'],
    ]);
    library.create('New');
    expect(stored(texts)).toEqual([pump, expect.objectContaining({ name: 'New' }), ...bad]);
    expect(libraryOn(texts).names()).toEqual(['Pump', 'New']);
  });

  it('have names of their own, whoever wrote the list', () => {
    const [first] = builtInSequences;
    const { names } = libraryOn(new Map([[KEY, fileOf(pump, pump, { ...pump, name: first!.name })]]));
    expect(names()).toEqual(['Pump', 'Pump (2)', `${first!.name} (2)`]);
  });

  it('are left alone if they are of a newer page, and changes last as long as the page', () => {
    const newer = fileOf().replace('1', '2');
    const texts = new Map([[KEY, newer]]);
    const { library, names } = libraryOn(texts);
    expect(library.notKept).toBe('unreadable');
    library.create('New');
    library.create('New');
    expect(names()).toEqual(['New', 'New (2)']);
    expect(library.notKept).toBe('unreadable');
    expect(texts.get(KEY)).toBe(newer);
  });
});

describe('a library', () => {
  it('shows the one that is chosen, or the first', () => {
    const { library, chosen } = libraryOn(new Map([[KEY, fileOf(pump)]]));
    expect(library.current).toBe(builtInSequences[0]);
    let told = 0;
    library.listeners.add(() => told++);
    library.choose('Pump');
    expect(library.current).toBe(library.own[0]);
    expect([chosen.value, told]).toEqual(['Pump', 1]);
    library.choose('gone');
    expect(library.current).toBe(builtInSequences[0]);
  });

  it('changes one of its own in place, and one that is built in as a copy', () => {
    const texts = new Map([[KEY, fileOf(pump)]]);
    const { library, names } = libraryOn(texts);
    const [first] = builtInSequences;
    expect(library.edit(withAbout(first!, 'mine'), 'about')).toBe(`${first!.name} (2)`);
    expect(names()).toEqual(['Pump', `${first!.name} (2)`]);
    library.choose('Pump');
    expect(library.edit({ ...library.current!, name: first!.name }, '')).toBe(`${first!.name} (3)`);
    expect(names()).toEqual([`${first!.name} (3)`, `${first!.name} (2)`]);
    expect(libraryOn(texts).names()).toEqual(names());
  });

  it('takes nothing that could not be read again', () => {
    const { library } = libraryOn(new Map());
    library.create('Long');
    const steps = Array.from({ length: 501 }, () => newStep('wait'));
    expect(library.edit({ ...library.current!, steps }, '')).toBeUndefined();
    expect(library.current?.steps).toHaveLength(0);
  });

  it('undoes step by step; what is typed into one field is one step', () => {
    const { library, chosen, names } = libraryOn(new Map());
    library.create('New');
    for (const about of ['a', 'ab', 'abc']) library.edit(withAbout(library.current!, about), 'about');
    library.edit({ ...library.current!, transport: 'ascii' }, '');
    library.remove();
    expect(names()).toEqual([]);
    library.undo();
    expect(library.current).toMatchObject({ name: 'New', about: 'abc', transport: 'ascii' });
    library.undo();
    expect(library.current).toMatchObject({ about: 'abc', transport: 'rtu' });
    library.undo();
    expect(library.current).toMatchObject({ name: 'New', about: '' });
    expect(library.canUndo).toBe(true);
    library.undo();
    expect([names(), chosen.value, library.canUndo]).toEqual([[], '', false]);
    library.undo();
    expect(names()).toEqual([]);
  });

  it('goes on when the storage is full, and stores all again once it is not', () => {
    const texts = new Map<string, string>();
    const { library, names } = libraryOn(texts, 400);
    library.create('A');
    library.edit(withAbout(library.current!, 'x'.repeat(1000)), 'about');
    expect(library.notKept).toBe('full');
    expect(library.current?.about).toHaveLength(1000);
    expect(stored(texts)).toMatchObject([{ name: 'A', about: '' }]);
    library.edit(withAbout(library.current!, 'short'), 'about');
    expect(library.notKept).toBeUndefined();
    expect(stored(texts)).toMatchObject([{ name: 'A', about: 'short' }]);
    expect(names()).toEqual(['A']);
  });

  it('follows what others store, and undoes nothing over it', () => {
    const texts = new Map<string, string>();
    const { library, list, names } = libraryOn(texts);
    library.create('A');
    texts.set(KEY, fileOf(pump));
    list.reload();
    library.changedElsewhere();
    expect([names(), library.canUndo]).toEqual([['Pump'], false]);
  });

  it('has the same sequence before and after it was stored', () => {
    const texts = new Map<string, string>();
    const { library } = libraryOn(texts);
    const made = { ...newSequence('Made'), steps: [newStep('send', { bytes: '06 03' }), newStep('until')] };
    library.add(made);
    expect(libraryOn(texts).library.own).toEqual([made]);
  });
});

describe('a file of sequences', () => {
  const words: SequenceImportWords = {
    unreadable: (file, { code }) => `${file}: ${code}`,
    emptyFile: 'empty',
    notTaken: (number, name, { code }) => `${number} ${name}: ${code}`,
    already: (name) => `${name} already`,
    imported: (name) => `${name} added`,
    renamed: (wanted, got) => `${wanted} is ${got}`,
  };

  it('adds what can be read, and says what became of each', () => {
    const { library, chosen, names } = libraryOn(new Map());
    const take = (text: string) => importSequences(library, text, 'file', words);
    const odd = { ...pump, name: 'Odd', steps: [{ kind: 'jump' }] };
    expect(take(fileOf(pump, odd))).toEqual(['Pump added', '2 Odd: not-a-step']);
    expect(take(fileOf({ ...pump, about: 'another' }, pump))).toEqual(['Pump is Pump (2)', 'Pump already']);
    expect([names(), chosen.value]).toEqual([['Pump', 'Pump (2)'], 'Pump']);
  });

  it('takes the frame of a link, as it is typed into the page', () => {
    const { library } = libraryOn(new Map());
    const link = 'rtu/request?unitId=6&functionCode=6&address=0x2AA&value=0';
    importSequences(library, fileOf({ ...pump, steps: [{ kind: 'send', link }] }), 'file', words);
    // AP 6.6: register 682 of unit 6 becomes 0.
    expect(library.current?.steps[0]?.fields).toMatchObject({ bytes: '06 06 02 AA 00 00 A9 E5' });
  });

  it('says why nothing was added', () => {
    const { library, names } = libraryOn(new Map());
    expect(importSequences(library, 'x', 'file', words)).toEqual(['file: not-json']);
    expect(importSequences(library, '{}', 'file', words)).toEqual(['file: not-sequences']);
    expect(importSequences(library, fileOf(), 'file', words)).toEqual(['empty']);
    expect(names()).toEqual([]);
  });
});
