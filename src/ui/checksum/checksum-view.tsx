import { useEffect } from 'preact/hooks';
import { ChecksumView, type DigestWorkers } from '../../store/index.ts';
import { part, Slot } from '../parts/slot.tsx';
import { page } from '../parts/store.ts';
import { useView, type ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import { startWorker } from '../parts/workers/start-worker.ts';
import { AlgorithmTable } from './algorithm-table.tsx';
import { Copied } from './copied-value.tsx';
import { INPUT, InputPanel } from './input-panel.tsx';
import { OwnPanel } from './own-panel.tsx';
import { Folded } from './remembered-fold.tsx';
import { ResultPanel } from './result-panel.tsx';
import { StepsPlace } from './steps-place.tsx';
import { WhichPanel } from './which-panel.tsx';
import './checksum.css';

const workers: DigestWorkers = {
  start: (task, take, ended) => {
    const worker = startWorker<typeof task, Parameters<typeof take>[0]>('digest', take, ended);
    worker.post(task);
    return worker.end;
  },
  most: navigator.hardwareConcurrency || 1,
  now: () => performance.now(),
};

const card = part(
  ['checksumCard', 'examples'],
  () => import('./card/card-view.tsx'),
  ({ Card }) => Card,
);

/** Any bytes, and every checksum over them. */
export function ChecksumPanels() {
  const words = useWords('checksum');
  const view = useView(words.title, () => new ChecksumView(page, workers, words.own));
  useEffect(() => takeWhatComes(view), [view]);
  return (
    <main class="checksum-view" onFocusOut={() => page.address.now()}>
      <Copied />
      <div class="columns">
        <InputPanel view={view} />
        <ResultPanel view={view} />
      </div>
      <Unknown view={view} />
      <StepsPlace view={view} />
      <Folded name="checksum-which" title={words.which} hint={words.whichHint} filled={view.shown.peek().claim !== ''}>
        {() => <WhichPanel view={view} />}
      </Folded>
      <Folded name="checksum-own" title={words.ownTitle} hint={words.ownHint} filled={hasOwn(view)}>
        {() => <OwnPanel view={view} />}
      </Folded>
      <Folded name="checksum-card" title={words.card} hint={words.cardHint}>
        {() => (
          <Slot
            part={card}
            with={{
              onUse: (bytes, algorithm) => {
                view.takeBytes(bytes);
                view.choose(algorithm);
                document.getElementById(INPUT)?.focus();
              },
            }}
          />
        )}
      </Folded>
      <Folded
        name="checksum-all"
        title={words.all}
        hint={words.allHint(view.rows.peek().length)}
        filled={view.search.peek() !== ''}
      >
        {() => <AlgorithmTable view={view} />}
      </Folded>
    </main>
  );
}

function hasOwn({ shown }: ChecksumView): boolean {
  const { width, poly } = shown.peek().own;
  return width + poly !== '';
}

function Unknown({ view }: ViewProps<ChecksumView>) {
  const words = useWords('checksum');
  const { algorithm } = view.shown.value;
  if (view.wanted.value) return null;
  return <p class="error">{words.unknown(algorithm, algorithm === 'own', view.chosen.value.name)}</p>;
}

/** What is dropped or pasted here is the input; elsewhere on the page it would be read as frames. Answers how to end that. */
function takeWhatComes(view: ChecksumView): () => void {
  const take = (event: Event, data: DataTransfer | null) => {
    const file = data?.files[0];
    const typed = event.target instanceof Element && event.target.closest('input, textarea, select') !== null;
    const text = data?.getData('text/plain') ?? '';
    if (file === undefined && (typed || text === '')) return;
    event.preventDefault();
    event.stopPropagation();
    if (file) view.change({ file });
    else view.takeText(text);
  };
  const watch = new AbortController();
  const first = { capture: true, signal: watch.signal };
  document.addEventListener('drop', (event) => take(event, event.dataTransfer), first);
  document.addEventListener('paste', (event) => take(event, event.clipboardData), first);
  return () => watch.abort();
}
