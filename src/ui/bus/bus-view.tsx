import type { ComponentType } from 'preact';
import { AddressedView } from '../../store/index.ts';
import { FoldPanel } from '../kit/fold.tsx';
import { Slot } from '../parts/slot.tsx';
import { page } from '../parts/store.ts';
import { useView } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import './bus.css';
import { ConnectionPanel } from './connection-panel.tsx';
import { LogPanel } from './log-panel.tsx';
import { Question } from './question.tsx';
import { SendPanel } from './send-panel.tsx';

const loadScan = () => import('./scan/load-scan.ts').then(({ loadPanel }) => loadPanel());
const loadListen = () => import('./listen/load-listen.ts').then(({ loadPanel }) => loadPanel());
const loadPoll = () => import('./poll/load-poll.ts').then(({ loadPanel }) => loadPanel());
const loadVirtual = () => import('./virtual/load-virtual.ts').then(({ loadPanel }) => loadPanel());
const loadSequences = () => import('./sequence/load-sequence.ts').then(({ loadPanel }) => loadPanel());

/** A part that comes when it is first opened, and stays. */
const fold = (title: string, load: () => Promise<ComponentType>) => (
  <FoldPanel title={title} keep>
    {() => <Slot part={load} with={{}} />}
  </FoldPanel>
);

/** A line of devices, real or virtual: connected, asked, and everything written down. Its address sends nothing. */
export function BusView() {
  const words = useWords('bus');
  const view = useView(
    words.title,
    () =>
      new AddressedView(
        page,
        'bus',
        (parts) => ({ search: parts.get('search') ?? '' }),
        (typed) => typed,
      ),
  );
  return (
    <main class="bus">
      <div class="columns">
        <ConnectionPanel />
        <div class="talk">
          <SendPanel />
          <LogPanel view={view} />
          {fold(words.poll, loadPoll)}
          {fold(words.virtualDevices, loadVirtual)}
          {fold(words.scan, loadScan)}
          {fold(words.listen, loadListen)}
          {fold(words.sequences, loadSequences)}
        </div>
      </div>
      <Question />
    </main>
  );
}
