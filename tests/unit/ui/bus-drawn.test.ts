import { h, render } from 'preact';
import { afterAll, beforeAll, expect, test, vi } from 'vitest';
import type { LogLine, SessionNews } from '../../../src/bus/index.ts';
import { languages, Vocabulary } from '../../../src/words/index.ts';
import type { SmallElement } from './small-document.ts';
import { Drawn, settle, stubWindow, times } from './small-window.ts';

// How much of the Bus view is drawn while a line is busy.

let root: SmallElement;
let drawn: Drawn;
let tell: (news: SessionNews) => void = () => undefined;

beforeAll(async () => {
  // Other files may have drawn the page, which knows its window from then on.
  vi.resetModules();
  const document = stubWindow('#bus');
  vi.stubGlobal('navigator', {});
  vi.stubGlobal('window', { isSecureContext: true, navigator });
  vi.stubGlobal('scrollTo', () => undefined);
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
  drawn = new Drawn();
}, 60_000);

afterAll(async () => {
  drawn.stop();
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
  drawn.names = [];
  for (let number = from; number < from + count; number++) tell({ kind: 'lines', lines: [line(number)] });
  await settle();
  return drawn.names;
}

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
