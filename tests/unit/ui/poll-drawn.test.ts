import { h, render } from 'preact';
import { afterAll, beforeAll, expect, test, vi } from 'vitest';
import { defaultSettings, type SessionCommand, type SessionNews } from '../../../src/bus/index.ts';
import { plainRegister } from '../../../src/devices/index.ts';
import { ALIVE } from '../../../src/ui/parts/workers/worker-alive.ts';
import { languages, Vocabulary } from '../../../src/words/index.ts';
import { framed } from '../bus/late-line.ts';
import { hex } from '../modbus/frames.ts';
import type { SmallElement } from './small-document.ts';
import { Drawn, settle, stubWindow } from './small-window.ts';

// How much of the panel is drawn while a poll runs.

vi.mock('../../../src/ui/bus/poll/chart.tsx', () => ({ Chart: () => null }));

// Unit 17, registers 107 to 109 (AP 6.3).
const READ = hex('11 03 00 6B 00 03 76 87');
const FIRST = hex('11 03 06 AE 41 56 52 43 40 49 AD');
/** The same but for register 107, which is one more. */
const NEXT = framed(0x11, 3, 6, 0xae, 0x42, 0x56, 0x52, 0x43, 0x40);

const value = (at: number) => ({
  name: `R${107 + at}`,
  place: '',
  register: { ...plainRegister, name: '', table: 'holding-register', address: 107 + at, type: 'u16' } as const,
  where: { read: 0, at, size: 1 },
});
const source = {
  title: 'Unit 17',
  transport: 'rtu',
  requests: [READ],
  reads: [{ quantity: 3, width: 1 }],
  values: [0, 1, 2].map(value),
  unreadable: [],
} as const;

let root: SmallElement;
let drawn: Drawn;
let tell: (news: SessionNews | typeof ALIVE) => void = () => undefined;
let job = 0;

beforeAll(async () => {
  const document = stubWindow('#bus');
  vi.stubGlobal('navigator', {});
  vi.stubGlobal('window', { isSecureContext: true, navigator });
  vi.stubGlobal(
    'Worker',
    class {
      onmessage: ((event: { data: SessionNews | typeof ALIVE; ports: readonly MessagePort[] }) => void) | undefined;
      constructor() {
        tell = (data) => this.onmessage?.({ data, ports: [] });
      }
      postMessage(command: SessionCommand) {
        if (command.kind === 'start-job') job = command.id;
      }
      terminate() {}
    },
  );
  const { Words } = await import('../../../src/ui/parts/words.ts');
  const { PollPanel } = await import('../../../src/ui/bus/poll/poll-panel.tsx');
  const { bus } = await import('../../../src/ui/bus/bus.ts');
  // The chart is there at once when it is asked for.
  await import('../../../src/ui/bus/poll/chart-panel.tsx');
  const { poll } = await import('../../../src/ui/bus/jobs.ts');
  const vocabulary = new Vocabulary(languages.en);
  await vocabulary.load('page', 'bus', 'poll', 'devices');
  root = document.createElement('div');
  render(h(Words.Provider, { value: vocabulary, children: h(PollPanel, {}) }), root as unknown as Element);
  bus.openVirtual();
  tell(ALIVE);
  const adapter = { kind: 'virtual' } as const;
  tell({ kind: 'state', state: { kind: 'open', adapter, settings: defaultSettings, since: 0 } });
  poll.start(source);
  await settle();
  drawn = new Drawn();
});

afterAll(async () => {
  drawn.stop();
  render(null, root as unknown as Element);
  await settle();
  vi.unstubAllGlobals();
});

/** The names of what is drawn when a request was answered so, or not at all. */
async function sampleComes(round: number, reply: Uint8Array | undefined): Promise<readonly string[]> {
  drawn.names = [];
  const outcome = reply
    ? ({ outcome: 'reply', verdict: 'good', reply } as const)
    : ({ outcome: 'silent', verdict: 'bad' } as const);
  tell({
    kind: 'jobs',
    news: [{ id: job, news: { kind: 'sample', index: 0, round, time: 1000 * round, ...outcome } }],
  });
  await settle();
  return drawn.names;
}

test('a reading changes the texts of its cells and the count, and draws no row', async () => {
  expect(root.textContent).toContain('Values: Unit 17');
  await sampleComes(1, FIRST);
  expect(root.textContent).toContain('44609');
  const names = await sampleComes(2, NEXT);
  expect(root.textContent).toContain('44610');
  expect(root.textContent).toContain('2 rounds');
  expect(names).toEqual(['Progress']);
});

test('a request that fails draws the rows of its values', async () => {
  const names = await sampleComes(3, undefined);
  expect(root.textContent).toContain('no answer');
  expect(names.filter((name) => name === 'ValueRow')).toHaveLength(3);
  expect(names).not.toContain('PollPanel');
  expect(names).not.toContain('ValueTable');
});
