import { h, render } from 'preact';
import { afterAll, beforeAll, expect, test, vi } from 'vitest';
import type { LogLine, SessionNews } from '../../../src/bus/index.ts';
import { ALIVE } from '../../../src/ui/parts/workers/worker-alive.ts';
import { languages, Vocabulary } from '../../../src/words/index.ts';
import { TraceDesk, type TraceTask } from '../../../src/workbench/index.ts';
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
      onmessage: ((event: { data: unknown; ports: readonly MessagePort[] }) => void) | undefined;
      #desk: TraceDesk | undefined;
      constructor(_address: string, { name }: { readonly name: string }) {
        if (name.startsWith('framewright-session')) tell = (data) => this.onmessage?.({ data, ports: [] });
        if (!name.startsWith('framewright-trace')) return;
        this.#desk = new TraceDesk((data) => this.onmessage?.({ data, ports: [] }), setTimeout);
        setTimeout(() => this.onmessage?.({ data: ALIVE, ports: [] }));
      }
      postMessage(task: TraceTask) {
        if (task.kind !== 'open') setTimeout(() => this.#desk?.take(task));
      }
      terminate() {}
    },
  );
  const { Words } = await import('../../../src/ui/parts/words.ts');
  const { BusView } = await import('../../../src/ui/bus/bus-view.tsx');
  const { bus } = await import('../../../src/ui/bus/bus.ts');
  const vocabulary = new Vocabulary(languages.en);
  await vocabulary.load('page', 'bus', 'trace');
  root = document.createElement('div');
  render(h(Words.Provider, { value: vocabulary, children: h(BusView, {}) }), root as unknown as Element);
  bus.openVirtual();
  await settle();
  drawn = new Drawn();
});

afterAll(async () => {
  drawn.stop();
  render(null, root as unknown as Element);
  await settle();
  vi.unstubAllGlobals();
  vi.resetModules();
});

const line = (number: number): LogLine => ({
  time: 1000 * number,
  direction: 'sent',
  transport: 'rtu',
  kind: 'request',
  hex: '1103006B00037687',
  verdict: 'silent',
});

/** The names of what is drawn when the session tells so many lines at once. */
async function linesCome(from: number, count: number): Promise<readonly string[]> {
  drawn.names = [];
  tell({ kind: 'lines', lines: Array.from({ length: count }, (_, at) => line(from + at)) });
  await settle();
  return drawn.names;
}

test('a busy line draws the rows and what is said of them, twice for a hundred, and nothing beside', async () => {
  expect(root.textContent).toContain('Nothing has been sent or received yet.');
  await linesCome(1, 1);
  const names = await linesCome(2, 100);
  expect(root.textContent).toContain('101 frames');
  expect(root.textContent).toContain('101 without a reply');
  expect(times(names, 'TraceRows')).toBe(2);
  // Twelve rows are in sight, and eight are there beyond them; the first of all was drawn before, the others wait and come.
  expect(times(names, 'Row')).toBe(2 * 19);
  expect(times(names, 'TraceSummaryLine')).toBe(1);
  // Text that is a signal is drawn by a component of its own.
  const known = [
    'TraceRows',
    'VirtualList',
    'Row',
    'MarkStrip',
    'Hint',
    'Kept',
    'TraceSummaryLine',
    'Part',
    'TraceCauses',
    '$',
  ];
  expect(names.filter((name) => !known.includes(name))).toEqual([]);
});
