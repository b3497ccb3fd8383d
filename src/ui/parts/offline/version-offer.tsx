import { render } from 'preact';
import type { Vocabulary, WordsOf } from '../../../words/index.ts';
import './version-offer.css';

/** Where it stands: beside the page, which runs on as it is. */
const place = document.createElement('div');

/** Offers the version of the page that the browser keeps, beside the one that runs. */
export async function offerVersion(worker: ServiceWorker, vocabulary: Vocabulary): Promise<void> {
  await vocabulary.load('offline');
  document.body.append(place);
  render(<Offer worker={worker} words={vocabulary.of('offline')} />, place);
}

const Offer = ({ worker, words }: { readonly worker: ServiceWorker; readonly words: WordsOf<'offline'> }) => (
  <section class="version-offer in-row" aria-label={words.newVersion}>
    <p role="status">{words.newVersion}</p>
    <button type="button" class="first" onClick={() => change(worker)}>
      {words.reload}
    </button>
    <button type="button" onClick={() => render(null, place)}>
      {words.later}
    </button>
  </section>
);

/** Loads the page again in its new version. What was typed is in the address. */
function change(worker: ServiceWorker): void {
  const asking = setInterval(() => {
    // Chromium does not always let a worker take over at the first call.
    if (worker.state === 'installed') return worker.postMessage('change');
    if (worker.state === 'activating') return;
    // It runs, for another window perhaps, or gave way to a newer one, which is offered next.
    clearInterval(asking);
    location.reload();
  }, 100);
}
