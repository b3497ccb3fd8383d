import type { Identity, Reason } from '../../../diagnosis/index.ts';
import { pasted } from '../../parts/pasted.ts';
import { draft } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';

/** The readings that follow are too unlikely to be shown. */
const SHOWN = 4;

/** The transport and direction in the list of frames were guessed from the same bytes: they are not evidence. */
const isEvidence = ({ code }: Reason) => code !== 'transport-given' && code !== 'direction-given';

const isCurrent = ({ transport, direction }: Identity) =>
  transport === draft.value.transport && (direction === 'request') === (draft.value.kind === 'request');

const identities = () => pasted.identity.value?.identities.slice(0, SHOWN) ?? [];

/** The other kinds of frame that the chosen bytes may be. */
export const otherIdentities = () => identities().filter((identity) => !isCurrent(identity));

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
