import { effect } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import { KeptChoice, SavedFrames } from '../../../src/store/index.ts';
import { oneOf } from '../../../src/workbench/index.ts';
import { TestBrowser } from './window.ts';

const sizes = ['small', 'middle', 'large'] as const;
type Size = (typeof sizes)[number];
const sizeIn = (browser: TestBrowser, of?: 'tab') =>
  new KeptChoice<Size>(browser.tab(), 'size', 'middle', oneOf(sizes), of);

describe('a choice', () => {
  it('outlives the page', () => {
    const browser = new TestBrowser();
    sizeIn(browser).value = 'large';
    expect(browser.texts.get('framewright.size')).toBe('"large"');
    expect(sizeIn(browser).value).toBe('large');
  });

  it.each([
    ['nothing', undefined],
    ['another type', '7'],
    ['a value that is not offered', '"huge"'],
    ['half a text', '"lar'],
  ])('is the initial one where %s is stored', (_, text) => {
    const browser = new TestBrowser();
    if (text !== undefined) browser.texts.set('framewright.size', text);
    expect(sizeIn(browser).value).toBe('middle');
  });

  it('follows another tab, and tells who reads it', () => {
    const browser = new TestBrowser();
    const [mine, theirs] = [sizeIn(browser), sizeIn(browser)];
    const seen: Size[] = [];
    effect(() => {
      seen.push(mine.value);
    });
    theirs.value = 'large';
    theirs.value = 'small';
    expect(seen).toEqual(['middle', 'large', 'small']);
  });

  it('is not written back by the tab that follows', () => {
    const browser = new TestBrowser();
    const size = sizeIn(browser);
    browser.store('framewright.size', '"huge"');
    expect(size.value).toBe('middle');
    expect(browser.texts.get('framewright.size')).toBe('"huge"');
  });

  it('keeps what it has where another tab stores half a text', () => {
    const browser = new TestBrowser();
    const size = sizeIn(browser);
    size.value = 'large';
    browser.store('framewright.size', '"lar');
    expect(size.value).toBe('large');
  });

  it('is the initial one after everything was cleared', () => {
    const browser = new TestBrowser();
    const size = sizeIn(browser);
    size.value = 'large';
    browser.clear();
    expect(size.value).toBe('middle');
  });

  it('of a tab stays when another tab chooses', () => {
    const browser = new TestBrowser();
    const [mine, theirs] = [sizeIn(browser, 'tab'), sizeIn(browser, 'tab')];
    theirs.value = 'large';
    expect(mine.value).toBe('middle');
    expect(sizeIn(browser, 'tab').value).toBe('large');
  });

  it('holds until the page is closed where storage is refused', () => {
    const browser = new TestBrowser();
    browser.refuses = true;
    const size = sizeIn(browser);
    size.value = 'small';
    expect(size.value).toBe('small');
    browser.refuses = false;
    expect(sizeIn(browser).value).toBe('middle');
  });
});

/** Links to two frames: a read of holding registers, and one of coils. */
const REGISTERS = 'rtu/request?unitId=1&functionCode=3&startAddress=0&quantity=1';
const COILS = 'rtu/request?unitId=1&functionCode=1&startAddress=0&quantity=1';

describe('saved frames', () => {
  const namesOf = ({ stored: { value } }: SavedFrames) =>
    value.kind === 'list' ? value.items.map(({ name }) => name) : value.kind;

  it('are those of all tabs', () => {
    const browser = new TestBrowser();
    const [mine, theirs] = [new SavedFrames(browser.tab()), new SavedFrames(browser.tab())];
    mine.save('pump', REGISTERS);
    theirs.save('valve', COILS);
    expect(namesOf(mine)).toEqual(['pump', 'valve']);
    theirs.delete('pump');
    expect(namesOf(mine)).toEqual(['valve']);
    expect(mine.delete('pump')).toBe('gone');
  });

  it('keep both of one name', () => {
    const frames = new SavedFrames(new TestBrowser().tab());
    expect(frames.save('pump', REGISTERS)).toEqual({ wanted: 'pump', got: 'pump' });
    expect(frames.save('pump', COILS)).toEqual({ wanted: 'pump', got: 'pump (2)' });
    expect(frames.rename('pump (2)', 'pump')).toEqual({ wanted: 'pump', got: 'pump (2)' });
  });

  it('come back to their place after they were deleted', () => {
    const frames = new SavedFrames(new TestBrowser().tab());
    for (const name of ['a', 'b', 'c']) frames.save(name, REGISTERS);
    frames.delete('b');
    frames.delete('a');
    expect(namesOf(frames)).toEqual(['c']);
    expect(frames.deleted.value.map(({ item }) => item.name)).toEqual(['b', 'a']);
    expect(frames.undo()).toEqual({ wanted: 'a', got: 'a' });
    expect(frames.undo()).toEqual({ wanted: 'b', got: 'b' });
    expect(namesOf(frames)).toEqual(['a', 'b', 'c']);
    expect(frames.undo()).toBe('gone');
  });

  it('come back under another name if theirs is taken meanwhile, and are kept for another try where the browser refuses', () => {
    const browser = new TestBrowser();
    const frames = new SavedFrames(browser.tab());
    frames.save('a', REGISTERS);
    frames.delete('a');
    frames.save('a', COILS);
    browser.refuses = true;
    expect(frames.undo()).toBe('refused');
    browser.refuses = false;
    expect(frames.undo()).toEqual({ wanted: 'a', got: 'a (2)' });
    expect(namesOf(frames)).toEqual(['a (2)', 'a']);
  });

  it('are imported once', () => {
    const frames = new SavedFrames(new TestBrowser().tab());
    frames.save('a', REGISTERS);
    const incoming = [
      { name: 'a', link: REGISTERS },
      { name: 'a', link: COILS },
    ];
    expect(frames.import(incoming)).toEqual({ added: [{ wanted: 'a', got: 'a (2)' }], already: 1 });
    expect(namesOf(frames)).toEqual(['a', 'a (2)']);
  });

  it('are not saved where the browser refuses', () => {
    const browser = new TestBrowser();
    const frames = new SavedFrames(browser.tab());
    browser.refuses = true;
    expect(frames.save('a', REGISTERS)).toBe('refused');
  });
});
