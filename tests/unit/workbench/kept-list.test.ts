import { describe, expect, it } from 'vitest';
import { KeptList, type ListCodec } from '../../../src/workbench/kept-list.ts';
import { storageOf } from './memory-storage.ts';

const KEY = 'framewright.words';

/** Words with a blank between them; capitals are rows that are not items, and an exclamation mark no list at all. */
const codec: ListCodec<string, 'shouted', string> = {
  read(text) {
    if (text.includes('!')) return { kind: 'unreadable', fault: 'shouted' };
    const all = text.split(' ').filter((word) => word !== '');
    const isBad = (word: string) => /[A-Z]/.test(word);
    return { kind: 'list', items: all.filter((word) => !isBad(word)), bad: all.filter(isBad) };
  },
  write: (items, bad) => [...items, ...bad].join(' '),
};

const listIn = (texts: Map<string, string>, room?: number) =>
  new KeptList('words', codec, () => storageOf(texts, room));

const append = (list: KeptList<string, 'shouted', string>, word: string) =>
  list.change((items) => ({ items: [...items, word], result: items.length }));

describe('a kept list', () => {
  it('is empty at first, and what is added stays for the next', () => {
    const texts = new Map<string, string>();
    const list = listIn(texts);
    expect(list.kept).toEqual({ kind: 'list', items: [], bad: [] });
    expect(append(list, 'pump')).toBe(0);
    expect(list.kept).toEqual({ kind: 'list', items: ['pump'], bad: [] });
    expect(texts).toEqual(new Map([[KEY, 'pump']]));
    expect(listIn(texts).kept).toEqual({ kind: 'list', items: ['pump'], bad: [] });
  });

  it('changes what is stored now, not what it last saw', () => {
    const texts = new Map([[KEY, 'pump']]);
    const list = listIn(texts);
    texts.set(KEY, 'pump fan');
    expect(append(list, 'drive')).toBe(2);
    expect(texts.get(KEY)).toBe('pump fan drive');
    texts.set(KEY, 'fan');
    expect(list.remove((word) => word === 'pump')).toBe('gone');
    expect(list.kept).toEqual({ kind: 'list', items: ['fan'], bad: [] });
  });

  it('keeps rows that are not items', () => {
    const texts = new Map([[KEY, 'pump BAD fan']]);
    const list = listIn(texts);
    expect(list.kept).toEqual({ kind: 'list', items: ['pump', 'fan'], bad: ['BAD'] });
    expect(list.remove((word) => word === 'pump')).toEqual({ item: 'pump', index: 0 });
    expect(texts.get(KEY)).toBe('fan BAD');
  });

  it('leaves a text alone that is not a list, until it is set aside under a key that is free', () => {
    const texts = new Map([
      [KEY, 'no!'],
      [`${KEY}.unreadable-1`, 'older'],
    ]);
    const list = listIn(texts);
    expect(list.kept).toEqual({ kind: 'unreadable', fault: 'shouted', text: 'no!' });
    expect(append(list, 'pump')).toBe('unreadable');
    expect(texts.get(KEY)).toBe('no!');
    expect(list.setUnreadableAside()).toEqual({ key: `${KEY}.unreadable-2` });
    expect(texts).toEqual(
      new Map([
        [`${KEY}.unreadable-1`, 'older'],
        [`${KEY}.unreadable-2`, 'no!'],
      ]),
    );
    expect(list.kept).toEqual({ kind: 'list', items: [], bad: [] });
    expect(list.setUnreadableAside()).toBe('gone');
  });

  it('changes nothing when the storage is full', () => {
    const texts = new Map([[KEY, 'pump']]);
    const list = listIn(texts, 4);
    expect(append(list, 'fan')).toBe('full');
    expect(list.kept).toEqual({ kind: 'list', items: ['pump'], bad: [] });
    texts.set(KEY, 'never!');
    expect(list.setUnreadableAside()).toBe('full');
    expect(texts).toEqual(new Map([[KEY, 'never!']]));
  });

  it('says that the storage refuses', () => {
    const forbidden = () => {
      throw new Error('SecurityError');
    };
    const list = new KeptList('words', codec, forbidden);
    expect(list.kept).toEqual({ kind: 'refused' });
    expect(append(list, 'pump')).toBe('refused');
    expect(list.setUnreadableAside()).toBe('refused');
    const readOnly = { ...storageOf(new Map()), setItem: forbidden };
    expect(append(new KeptList('words', codec, () => readOnly), 'pump')).toBe('refused');
  });

  it('tells of each list that it sees', () => {
    const seen: unknown[] = [];
    class Told extends KeptList<string, 'shouted', string> {
      protected override changed(kept: unknown) {
        seen.push(kept);
      }
    }
    const texts = new Map<string, string>();
    const list = new Told('words', codec, () => storageOf(texts));
    append(list, 'pump');
    expect(seen.at(-1)).toEqual({ kind: 'list', items: ['pump'], bad: [] });
    texts.clear();
    list.reload();
    expect(seen.at(-1)).toEqual({ kind: 'list', items: [], bad: [] });
  });
});
