import { findChecksums, MOST_SEARCHED } from '../../diagnosis/index.ts';
import { formatBytes } from '../../notation/index.ts';
import { readClaim } from '../../workbench/index.ts';
import { TextField } from '../kit/text-field.tsx';
import { checksumWords as words } from './checksum-words.ts';

interface WhichProps {
  /** The input; absent while it is read, or if it is too large to be held. */
  readonly bytes: Uint8Array | undefined;
  readonly computing: boolean;
  readonly claim: string;
  readonly onClaim: (claim: string) => void;
  readonly onChoose: (algorithm: string) => void;
  readonly onLeave: () => void;
}

const ID = 'checksum-claim';
/** More are not worth reading. */
const MOST_SHOWN = 8;

/** Which algorithm, byte order and part of the bytes give a value: one that is typed, or the one at the end of the bytes. */
export function WhichPanel({ bytes, computing, claim, onClaim, onChoose, onLeave }: WhichProps) {
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
        onText={onClaim}
        onLeave={onLeave}
      />
      <div aria-live="polite">
        {!wrong && <Matches bytes={bytes} computing={computing} claims={claims} onChoose={onChoose} />}
      </div>
    </>
  );
}

interface MatchesProps extends Pick<WhichProps, 'bytes' | 'computing' | 'onChoose'> {
  readonly claims: readonly Uint8Array[];
}

function Matches({ bytes, computing, claims, onChoose }: MatchesProps) {
  if (computing) return <p class="said">{words.waiting}</p>;
  if (bytes === undefined || bytes.length > MOST_SEARCHED) return <p class="said">{words.tooLong(MOST_SEARCHED)}</p>;
  const matches = claims.length === 0 ? findChecksums(bytes) : claims.flatMap((claim) => findChecksums(bytes, claim));
  if (matches.length === 0) return <p>{claims.length === 0 ? words.noneAtEnd : words.noMatch}</p>;
  return (
    <ul class="matches" aria-label={words.matches}>
      {matches.slice(0, MOST_SHOWN).map((match) => (
        <li key={`${match.algorithm} ${match.start} ${match.from} ${match.to} ${match.text}`}>
          <b>{match.algorithm}</b> {words.match(match, bytes.length)}{' '}
          {match.at !== undefined && <span class="mono">{formatBytes(bytes.subarray(match.at))}</span>}{' '}
          <span class="said">{words.chance(match.chance)}</span>{' '}
          <button
            type="button"
            aria-label={words.chooseNamed(match.algorithm)}
            onClick={() => onChoose(match.algorithm)}
          >
            {words.chooseMatch}
          </button>
        </li>
      ))}
    </ul>
  );
}
