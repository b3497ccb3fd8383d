import { h, render } from 'preact';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { languages, Vocabulary } from '../../../src/words/index.ts';
import type { SmallElement } from './small-document.ts';
import { settle, stubWindow } from './small-window.ts';

// When a field of the form gets what reads values as people write them.

const SCALE = JSON.stringify({ factor: '8192/60', unit: 'Hz' });
const LINK = '#rtu/request?unitId=6&functionCode=6&address=683';

let root: SmallElement;
let vocabulary: Vocabulary;
let faults: unknown[] = [];

/** Draws the field of the value in the form of a link. */
async function draw(hash: string) {
  const document = stubWindow(hash);
  vi.stubGlobal('reportError', (error: unknown) => faults.push(error));
  vi.stubGlobal('localStorage', {
    getItem: (key: string) => (key === 'framewright.scale' ? SCALE : null),
    setItem: () => undefined,
  });
  const { Words } = await import('../../../src/ui/parts/words.ts');
  const { FieldControl } = await import('../../../src/ui/frame/field-control.tsx');
  const { page } = await import('../../../src/ui/parts/store.ts');
  root = document.createElement('div');
  render(h(Words.Provider, { value: vocabulary, children: h(FieldControl, { path: 'value' }) }), root as never);
  await settle();
  return page;
}

const field = () => root.byId('f-value');
const hasCome = () => {
  try {
    return vocabulary.of('values') !== undefined;
  } catch {
    return false;
  }
};

beforeEach(async () => {
  vi.resetModules();
  faults = [];
  vocabulary = new Vocabulary(languages.en);
  await vocabulary.load('page', 'tools', 'complaints');
});

afterEach(async () => {
  expect(faults).toEqual([]);
  const { page } = await import('../../../src/ui/parts/store.ts');
  render(null, root as never);
  page.address.drop();
  await settle();
  vi.unstubAllGlobals();
  // The page knows its window from then on: other tests get a page of their own.
  vi.resetModules();
});

test('a plain number in a field that nobody has touched needs nothing', async () => {
  await draw(`${LINK}&value=1`);
  expect(hasCome()).toBe(false);
  field()?.dispatch('focusin', {});
  await settle();
  expect(hasCome()).toBe(true);
});

test('what is typed before the reader has come is read when it comes', async () => {
  const page = await draw(`${LINK}&value=1`);
  field()?.dispatch('input', { value: '30 Hz' });
  expect(page.draft.value.texts['value']).toBe('30 Hz');
  await settle();
  expect(page.draft.value.texts['value']).toBe('4096');
  expect(root.textContent).toContain('30 Hz is 4096 (0x1000)');
  field()?.dispatch('input', { value: '60 Hz' });
  expect(page.draft.value.texts['value']).toBe('8192');
});

test('a value typed elsewhere is shown as typed', async () => {
  const page = await draw(`${LINK}&value=4096&v=2&typed.value=30+Hz`);
  expect(page.draft.value.texts['value']).toBe('4096');
  expect(field()?.attributes.get('value')).toBe('30 Hz');
});

test('a text that was not typed here stays, with what is to be done', async () => {
  const page = await draw(`${LINK}&value=30+Hz`);
  expect(page.draft.value.texts['value']).toBe('30 Hz');
  expect(root.textContent).toContain('Type it again to put it into the frame.');
});
