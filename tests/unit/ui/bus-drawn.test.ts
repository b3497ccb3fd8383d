import { h, options, render } from 'preact';
import { afterAll, beforeAll, expect, test, vi } from 'vitest';
import type { LogLine, SessionNews } from '../../../src/bus/index.ts';
import { languages, Vocabulary } from '../../../src/words/index.ts';
import { SmallDocument, type SmallElement } from './small-document.ts';

// How much of the Bus view is drawn while a line is busy.

let root: SmallElement;
let drawn: string[] = [];
let before: ((node: unknown) => void) | undefined;
let tell: (news: SessionNews) => void = () => undefined;

/** Lets what is to be loaded and drawn come. */
async function settle(): Promise<void> {
  for (let turn = 0; turn < 50; turn++) await new Promise((done) => setTimeout(done, 4));
}

beforeAll(async () => {
  // Other files may have drawn the page, which knows its window from then on.
  vi.resetModules();
  const document = new SmallDocument();
  vi.stubGlobal('document', document);
  vi.stubGlobal('navigator', {});
  vi.stubGlobal('window', { isSecureContext: true, navigator });
  vi.stubGlobal('location', { hash: '#bus', pathname: '/', search: '' });
  vi.stubGlobal('history', { replaceState: () => undefined, pushState: () => undefined });
  vi.stubGlobal('addEventListener', () => undefined);
  vi.stubGlobal('scrollTo', () => undefined);
  vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
  vi.stubGlobal(
    'ResizeObserver',
    class {
      observe() {}
      disconnect() {}
    },
  );
  vi.stubGlobal(
    'Worker',
    class {
      onmessage: ((event: { data: SessionNews }) => void) | undefined;
      constructor() {
        tell = (data) => this.onmessage?.({ data });
      }
      postMessage() {}
      terminate() {}
    },
  );
  const { Words } = await import('../../../src/ui/parts/words.ts');
  const { BusView } = await import('../../../src/ui/bus/bus-view.tsx');
  const { bus } = await import('../../../src/ui/bus/bus.ts');
  const vocabulary = new Vocabulary(languages.en);
  await vocabulary.load('page', 'bus');
  root = document.createElement('div');
  render(h(Words.Provider, { value: vocabulary, children: h(BusView, {}) }), root as unknown as Element);
  bus.openVirtual();
  await settle();
  before = Reflect.get(options, '__r');
  Reflect.set(options, '__r', (node: { readonly type: { readonly name: string } }) => {
    before?.(node);
    drawn.push(node.type.name);
  });
}, 60_000);

afterAll(async () => {
  Reflect.set(options, '__r', before);
  render(null, root as unknown as Element);
  await settle();
  vi.unstubAllGlobals();
  vi.resetModules();
});

const line = (number: number): LogLine => ({
  number,
  time: 0,
  direction: 'sent',
  transport: 'rtu',
  kind: 'request',
  hex: '110300 6B00037687'.replaceAll(' ', ''),
});

/** The names of what is drawn when the session tells so many lines, one after another. */
async function linesCome(from: number, count: number): Promise<readonly string[]> {
  drawn = [];
  for (let number = from; number < from + count; number++) tell({ kind: 'lines', lines: [line(number)] });
  await settle();
  return drawn;
}

const times = (names: readonly string[], name: string) => names.filter((each) => each === name).length;

test('a busy line draws the lines and their count, twice for a hundred, and nothing beside', async () => {
  expect(root.textContent).toContain('Nothing has been sent or received yet.');
  await linesCome(1, 1);
  const names = await linesCome(2, 100);
  expect(root.textContent).toContain('101 lines');
  expect(times(names, 'Count')).toBe(2);
  expect(times(names, 'LogList')).toBe(2);
  // Twelve lines are in sight, and eight are drawn beyond them: one of them before.
  expect(times(names, 'Line')).toBe(19);
  const rest = names.filter((name) => !['Count', 'Lines', 'LogList', 'VirtualList', 'Line'].includes(name));
  expect(rest).toEqual([]);
});
