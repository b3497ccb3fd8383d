import type { Identity, Reason } from '../../../diagnosis/index.ts';
import { pasted } from '../../parts/pasted.ts';
import { draft, page } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';

/** The readings that follow are too unlikely to be shown. */
const SHOWN = 4;

/** The transport and direction in the list of frames were guessed from the same bytes: they are not evidence. */
const isEvidence = ({ code }: Reason) => code !== 'transport-given' && code !== 'direction-given';

const isCurrent = ({ transport, direction }: Identity) =>
  transport === draft.value.transport && (direction === 'request') === (draft.value.kind === 'request');

const identities = () => pasted.identity.value?.identities.slice(0, SHOWN) ?? [];

/** The other kinds of frame that the chosen bytes may be, one click each. */
export function OtherIdentities() {
  const words = useWords('read');
  const { transports } = useWords('page').page;
  const request = pasted.identity.value?.request;
  return (
    <>
      {identities().map((identity) => {
        const name = `${transports[identity.transport]} ${words.directions[identity.direction]}`;
        return (
          !isCurrent(identity) && (
            <button key={name} type="button" onClick={() => page.showReading(identity.reading, request, 'step')}>
              {words.readSo(name)}
            </button>
          )
        );
      })}
    </>
  );
}

/** What the chosen bytes may be, with the reasons. */
export function WhatItIs() {
  const words = useWords('read');
  return (
    <ol class="identities">
      {identities().map((identity) => (
        <li key={`${identity.transport} ${identity.direction}`} aria-current={isCurrent(identity) || undefined}>
          {words.identity({ ...identity, reasons: identity.reasons.filter(isEvidence) })}.
        </li>
      ))}
    </ol>
  );
}
