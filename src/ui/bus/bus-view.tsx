import type { ComponentChildren } from 'preact';
import { type BusTab, BusView as BusViewState, busTabs } from '../../store/index.ts';
import { Tabs } from '../kit/tabs.tsx';
import { part, Slot } from '../parts/slot.tsx';
import { page } from '../parts/store.ts';
import { useView } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import './bus.css';
import './jobs.ts';
import { Question } from '../parts/question.tsx';
import { bus } from './bus.ts';
import { ConnectionPanel } from './connection-panel.tsx';
import { LogPanel } from './log-panel.tsx';
import { ReplyPanel } from './reply-panel.tsx';
import { SendPanel } from './send-panel.tsx';

const frame = part(
  ['tools'],
  () => import('./frame-panel.tsx'),
  ({ FramePanel }) => FramePanel,
);
const noAnswer = part(
  ['noAnswer'],
  () => import('./no-answer/no-answer-panel.tsx'),
  ({ NoAnswerPanel }) => NoAnswerPanel,
);
const scan = part(
  ['scan'],
  () => import('./scan/scan-panel.tsx'),
  ({ ScanPanel }) => ScanPanel,
);
const listen = part(
  ['listen'],
  () => import('./listen/listen-panel.tsx'),
  ({ ListenPanel }) => ListenPanel,
);
const sequences = part(
  ['sequence', 'complaints'],
  () => import('./sequence/sequence-panel.tsx'),
  ({ SequencePanel }) => SequencePanel,
);
const poll = part(
  ['poll', 'bus', 'devices'],
  () => import('./poll/poll-panel.tsx'),
  ({ PollPanel }) => PollPanel,
);
const virtual = part(
  ['virtual', 'devices'],
  () => import('./virtual/virtual-panel.tsx'),
  ({ VirtualPanel }) => VirtualPanel,
);

/** The panels of which one is open. Each comes when it is first opened, and goes on while another is. */
const panels: Readonly<Record<BusTab, (view: BusViewState) => ComponentChildren>> = {
  reply: () => <ReplyPanel />,
  frame: (view) => <Slot part={frame} with={{ view }} />,
  'no-answer': (view) => <Slot part={noAnswer} with={{ view }} />,
  poll: () => <Slot part={poll} with={{}} />,
  scan: () => <Slot part={scan} with={{}} />,
  listen: () => <Slot part={listen} with={{}} />,
  sequence: () => <Slot part={sequences} with={{}} />,
  virtual: () => <Slot part={virtual} with={{}} />,
};

/** A line of devices, real or virtual: connected, asked, and everything written down. Its address sends nothing. */
export function BusView() {
  const words = useWords('bus');
  const view = useView(words.title, () => new BusViewState(page, bus));
  return (
    <main class="bus">
      <ConnectionPanel />
      <div class="desk">
        <div class="stack">
          <SendPanel view={view} />
          <LogPanel view={view} />
        </div>
        <div class="panel work">
          <Tabs
            label={words.tabs.label}
            tabs={busTabs.map((id) => ({ id, name: words.tabs.names[id], panel: () => panels[id](view) }))}
            chosen={view.shown.value.tab}
            onChoose={view.open}
          />
        </div>
      </div>
      <Question bus={bus} />
    </main>
  );
}
