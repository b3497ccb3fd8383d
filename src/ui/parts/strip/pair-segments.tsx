import { useSteady } from '../steady.ts';
import { page } from '../store.ts';
import { useWords } from '../words.ts';
import './cause.css';

/** The request and the reply that belong together, of which one is shown; the other is one click away, and so is parting them. */
export function PairSegments() {
  const { pair: words } = useWords('stripMore');
  const pair = useSteady(() => {
    const { value } = page.pair;
    return value && { why: value.why, shown: page.kind.value === 'request' ? 'request' : 'reply' };
  }).value;
  if (pair === undefined) return null;
  const { why, shown } = pair;
  const segment = (which: 'request' | 'reply', go: () => void) => (
    <button type="button" aria-pressed={shown === which} onClick={go}>
      {words[which]}
    </button>
  );
  return (
    <div class="pair">
      {/* biome-ignore lint/a11y/useSemanticElements: a fieldset is for fields. */}
      <span class="pair-segments" role="group" aria-label={words.label}>
        {segment('request', page.toRequest)}
        {segment('reply', page.toReply)}
      </span>
      <span>{words.why[why]}</span>
      <button type="button" class="why-button" onClick={page.part}>
        {words.part}
      </button>
    </div>
  );
}
