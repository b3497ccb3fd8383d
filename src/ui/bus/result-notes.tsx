import type { SentResult } from '../../bus/index.ts';
import { useWords } from '../parts/words.ts';
import { bus } from './bus.ts';

/** What else is known of what became of a request. */
export function ResultNotes({ last: { unsure, slow, echo, strays } }: { readonly last: SentResult }) {
  const text = useWords('bus').send;
  return (
    <>
      {unsure && <p class="said">{text.unsure[unsure]}</p>}
      {slow !== undefined && <p class="said">{text.slow(slow, bus.rules.value.timeout)}</p>}
      {echo !== 'none' && <p class="said">{text.echo[echo]}</p>}
      {strays > 0 && echo !== 'removed' && <p class="said">{text.strays(strays)}</p>}
    </>
  );
}
