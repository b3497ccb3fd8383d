import { findChecksums, MOST_SEARCHED } from '../../diagnosis/index.ts';
import { formatBytes } from '../../notation/index.ts';
import type { ChecksumView } from '../../store/index.ts';
import { readClaim } from '../../workbench/index.ts';
import { TextField } from '../kit/text-field.tsx';
import type { ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';

const ID = 'checksum-claim';
/** More are not worth reading. */
const MOST_SHOWN = 8;

/** Which algorithm, byte order and part of the bytes give a value: one that is typed, or the one at the end of the bytes. */
export function WhichPanel({ view }: ViewProps<ChecksumView>) {
  const words = useWords('checksum');
  const { claim } = view.shown.value;
  const claims = readClaim(claim);
  const wrong = claim.trim() !== '' && claims.length === 0;
  return (
    <>
      <TextField
        id={ID}
        label={words.claim}
        text={claim}
        error={wrong ? words.notAClaim(claim.trim()) : ''}
        hint={words.claimHint}
        onText={(typed) => view.change({ claim: typed })}
      />
      <div aria-live="polite">{!wrong && <Matches view={view} claims={claims} />}</div>
    </>
  );
}

interface MatchesProps extends ViewProps<ChecksumView> {
  readonly claims: readonly Uint8Array[];
}

function Matches({ view, claims }: MatchesProps) {
  const words = useWords('checksum');
  const bytes = view.bytes.value;
  if (view.computing.value) return <p class="said">{words.waiting}</p>;
  if (bytes === undefined || bytes.length > MOST_SEARCHED) return <p class="said">{words.tooLong(MOST_SEARCHED)}</p>;
  const matches = claims.length === 0 ? findChecksums(bytes) : claims.flatMap((claim) => findChecksums(bytes, claim));
  if (matches.length === 0) return <p>{claims.length === 0 ? words.noneAtEnd : words.noMatch}</p>;
  return (
    <ul class="matches edges stack" aria-label={words.matches}>
      {matches.slice(0, MOST_SHOWN).map((match) => (
        <li key={`${match.algorithm} ${match.start} ${match.from} ${match.to} ${match.text}`}>
          <b>{match.algorithm}</b> {words.match(match, bytes.length)}{' '}
          {match.at !== undefined && <span class="mono">{formatBytes(bytes.subarray(match.at))}</span>}{' '}
          <span class="said">{words.chance(match.chance)}</span>{' '}
          <button
            type="button"
            aria-label={words.chooseNamed(match.algorithm)}
            onClick={() => view.choose(match.algorithm)}
          >
            {words.chooseMatch}
          </button>
        </li>
      ))}
    </ul>
  );
}
