import { h, render } from 'preact';
import { afterAll, beforeAll, expect, test, vi } from 'vitest';
import { languages, Vocabulary } from '../../../src/words/index.ts';
import { readLink } from '../../../src/workbench/index.ts';
import type { SmallElement } from './small-document.ts';
import { Drawn, settle, stubWindow, times } from './small-window.ts';

// How much of the page is drawn for a keystroke: the page itself, in a document that is just enough to draw into.

const LINK = '#rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3';

let root: SmallElement;
let drawn: Drawn;
const faults: unknown[] = [];

beforeAll(async () => {
  const document = stubWindow(LINK);
  vi.stubGlobal('reportError', (error: unknown) => faults.push(error));
  vi.stubGlobal(
    'IntersectionObserver',
    class {
      constructor(private readonly tell: (entries: readonly { readonly isIntersecting: boolean }[]) => void) {}
      observe() {
        this.tell([{ isIntersecting: true }]);
      }
      disconnect() {}
    },
  );
  // A test before this one may have opened another view.
  vi.resetModules();
  const { App } = await import('../../../src/ui/app.tsx');
  await import('../../../src/ui/parts/frame-tabs/later-tab.tsx');
  await import('../../../src/ui/parts/frame-tabs/values/values.tsx');
  await import('../../../src/ui/parts/frame-tabs/values/values-panel.tsx');
  root = document.createElement('div');
  const vocabulary = new Vocabulary(languages.en);
  await vocabulary.load('page', 'complaints', 'tools', 'values');
  render(h(App, { vocabulary }), root as unknown as Element);
  await settle();
  drawn = new Drawn();
});

afterAll(async () => {
  drawn.stop();
  // What still waits for a pause would find no window afterwards.
  const { page } = await import('../../../src/ui/parts/store.ts');
  render(null, root as unknown as Element);
  page.address.drop();
  await settle();
  vi.unstubAllGlobals();
});

async function type(id: string, value: string): Promise<readonly string[]> {
  drawn.names = [];
  root.byId(id)?.dispatch('input', { value });
  await settle();
  return drawn.names;
}

test('a keystroke in a short frame draws what it changes', async () => {
  expect(faults).toEqual([]);
  expect(root.textContent).toContain('Unit 17 is addressed');
  await type('f-quantity', '4');
  const names = await type('f-quantity', '5');
  expect(root.textContent).toContain('The last is 111');
  // Of five fields in the strip the quantity and the CRC, and of five lines those that say something else.
  expect(times(names, 'Run')).toBe(2);
  expect(times(names, 'Line')).toBe(3);
  for (const other of [
    'Views',
    'Verdict',
    'WireStrip',
    'StripField',
    'FieldList',
    'Explanation',
    'Group',
    'FrameView',
    'Form',
    'Segments',
    'FunctionChoice',
    'Combobox',
    'ReadPlace',
    'DevicePlace',
    'Shelf',
  ])
    expect(names).not.toContain(other);
  expect(names.length).toBeLessThanOrEqual(25);
});

test('a keystroke in a frame of 255 bytes draws not many more', async () => {
  const registers = Array.from({ length: 123 }, (_, index) => index);
  const { page } = await import('../../../src/ui/parts/store.ts');
  page.step(readLink(`rtu/request?unitId=17&functionCode=16&startAddress=107&registers=${registers.join('+')}`)!.draft);
  await settle();
  await type('f-registers', [...registers.slice(0, -1), 7].join(' '));
  const names = await type('f-registers', [...registers.slice(0, -1), 77].join(' '));
  expect(times(names, 'Run')).toBe(2);
  // Everything counts as in sight here, also all groups of the explanation.
  expect(names.length).toBeLessThanOrEqual(30);
});

test('a tab that is closed keeps its state and is not drawn while somebody types', async () => {
  const { page } = await import('../../../src/ui/parts/store.ts');
  page.step(readLink('rtu/request?unitId=17&functionCode=16&startAddress=107&registers=1+2')!.draft);
  page.openTab('values');
  await settle();
  expect(root.textContent).toContain('What it may be');
  expect(await type('f-registers', '1 3')).toContain('ValuesTab');
  page.openTab('bytes');
  await settle();
  const names = await type('f-registers', '1 4');
  expect(times(names, 'Line')).toBeGreaterThan(0);
  for (const other of ['ValuesTab', 'ValuesPanel', 'WidthTable']) expect(names).not.toContain(other);
  expect(root.textContent).toContain('What it may be');
});
