import { AddressedView } from '../../store/index.ts';
import { FoldPanel } from '../kit/fold.tsx';
import { type Part, part, Slot } from '../parts/slot.tsx';
import { page } from '../parts/store.ts';
import { useView } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import './bus.css';
import { bus } from './bus.ts';
import { ConnectionPanel } from './connection-panel.tsx';
import { LogPanel } from './log-panel.tsx';
import { Question } from './question.tsx';
import { SendPanel } from './send-panel.tsx';

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

/** A part that comes when it is first opened, and stays. */
const fold = (title: string, panel: Part<object>) => (
  <FoldPanel title={title} keep>
    {() => <Slot part={panel} with={{}} />}
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
        <div class="stack">
          <SendPanel />
          <LogPanel view={view} />
          {fold(words.poll, poll)}
          {fold(words.virtualDevices, virtual)}
          {fold(words.scan, scan)}
          {fold(words.listen, listen)}
          {fold(words.sequences, sequences)}
        </div>
      </div>
      <Question />
    </main>
  );
}

/** How the line stands, in the header of every view; nothing while there is none. */
export function BusStatus() {
  const status = useWords('bus').linkShort(bus.link.value);
  return status && <small role="status">{status}</small>;
}
