import type { Reason } from '../../../diagnosis/index.ts';
import { pasted } from '../../parts/pasted.ts';
import { draft, page } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';

/** The readings that follow are too unlikely to be shown. */
const SHOWN = 4;

/** The transport and direction in the list of frames were guessed from the same bytes: they are not evidence. */
const isEvidence = ({ code }: Reason) => code !== 'transport-given' && code !== 'direction-given';

/** What the chosen bytes may be, with the reasons, and one click to take them so. */
export function WhatItIs() {
  const words = useWords('read');
  const { transports } = useWords('page').page;
  const found = pasted.identity.value;
  if (found === undefined) return null;
  const { transport, kind } = draft.value;
  return (
    <section class="identities" aria-labelledby="what-it-is">
      <h3 id="what-it-is">{words.whatElse}</h3>
      <ol>
        {found.identities.slice(0, SHOWN).map((identity) => {
          const name = `${transports[identity.transport]} ${words.directions[identity.direction]}`;
          const current =
            identity.transport === transport && (identity.direction === 'request') === (kind === 'request');
          return (
            <li key={name} aria-current={current || undefined}>
              {words.identity({ ...identity, reasons: identity.reasons.filter(isEvidence) })}.{' '}
              {current ? (
                <span class="said">{words.asIs}</span>
              ) : (
                <button type="button" onClick={() => page.showReading(identity.reading, found.request, 'step')}>
                  {words.readSo(name)}
                </button>
              )}
            </li>
          );
        })}
      </ol>
    </section>
  );
}
