import type { Kept, Refusal } from '../../workbench/index.ts';
import { download } from '../kit/download.ts';

interface FaultWords<Fault, Bad> {
  readonly refusals: Readonly<Record<Refusal, string>>;
  readonly unreadable: (fault: Fault) => string;
  readonly badItems: (count: number) => string;
  readonly badItem: (bad: Bad) => string;
  readonly download: string;
  readonly setAside: string;
  readonly setAsideAs: (key: string) => string;
  readonly fileName: string;
}

interface KeptFaultProps<T, Fault, Bad> {
  readonly list: {
    readonly stored: { readonly value: Kept<T, Fault, Bad> | { readonly kind: 'full' } };
    setUnreadableAside(): { readonly key: string } | Refusal;
  };
  readonly words: FaultWords<Fault, Bad>;
  readonly onMessage: (message: string) => void;
}

/** What cannot be used of a list kept in the browser, and what a person can do about it. Nothing is thrown away. */
export function KeptFault<T, Fault, Bad>({ list, words, onMessage }: KeptFaultProps<T, Fault, Bad>) {
  const { value: stored } = list.stored;
  if (stored.kind === 'refused' || stored.kind === 'full')
    return (
      <p class="kept-fault edged" data-severity="error">
        {words.refusals[stored.kind]}
      </p>
    );
  if (stored.kind === 'list') {
    if (stored.bad.length === 0) return null;
    return (
      <div class="kept-fault edged" data-severity="error">
        <p>{words.badItems(stored.bad.length)}</p>
        {stored.bad.map((bad, index) => (
          <p key={index}>{words.badItem(bad)}</p>
        ))}
      </div>
    );
  }
  const setAside = () => {
    const outcome = list.setUnreadableAside();
    onMessage(typeof outcome === 'string' ? words.refusals[outcome] : words.setAsideAs(outcome.key));
  };
  return (
    <div class="kept-fault edged" data-severity="error">
      <p>{words.unreadable(stored.fault)}</p>
      <p class="row-actions">
        <button type="button" onClick={() => download(stored.text, words.fileName)}>
          {words.download}
        </button>{' '}
        <button type="button" onClick={setAside}>
          {words.setAside}
        </button>
      </p>
    </div>
  );
}
