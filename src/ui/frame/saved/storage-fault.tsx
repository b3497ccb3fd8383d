import { download } from '../../kit/download.ts';
import { useWords } from '../../parts/words.ts';
import { savedFrames } from './saved-frames.ts';
import { refusalText } from './saved-messages.ts';

interface FaultProps {
  readonly onMessage: (message: string) => void;
}

/** Stored frames that cannot be used, and what a person can do about it. Nothing is thrown away. */
export function StorageFault({ onMessage }: FaultProps) {
  const words = useWords('saved');
  const { value: stored } = savedFrames.stored;
  if (stored.kind === 'refused') return <p class="saved-fault">{words.refused}</p>;
  if (stored.kind === 'unreadable') {
    return (
      <div class="saved-fault">
        <p>
          {words.unreadable(stored.fault)} {words.unreadableKept}
        </p>
        <p class="row-actions">
          <button type="button" onClick={() => download(stored.text, words.fileName)}>
            {words.download}
          </button>{' '}
          <button
            type="button"
            onClick={() => {
              const outcome = savedFrames.setUnreadableAside();
              onMessage(typeof outcome === 'string' ? refusalText(words, outcome, '') : words.setAsideAs(outcome.key));
            }}
          >
            {words.setAside}
          </button>
        </p>
      </div>
    );
  }
  if (stored.bad.length === 0) return null;
  return (
    <div class="saved-fault">
      <p>{words.unreadableRows(stored.bad.length)}</p>
      {stored.bad.map(({ row, why }) => (
        <p key={row}>{words.storedRow(row, why)}</p>
      ))}
    </div>
  );
}
