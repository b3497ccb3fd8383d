import { checksumWords as words } from './checksum-words.ts';
import type { Digest } from './digest.ts';

interface ProgressProps {
  readonly digest: Digest;
  readonly onCancel: () => void;
  readonly onAgain: () => void;
}

/** How far the bytes are read, and how fast. */
export function FileProgress({ digest, onCancel, onAgain }: ProgressProps) {
  return (
    <>
      {digest.kind === 'computing' && (
        <p class="digest">
          <progress aria-label={words.computing} value={digest.done} max={Math.max(1, digest.size)} />{' '}
          {words.progress(digest.done, digest.size, digest.speed)}{' '}
          <button type="button" onClick={onCancel}>
            {words.cancel}
          </button>
        </p>
      )}
      {/* How far it is would be read out several times a second. */}
      <div aria-live="polite">
        {digest.kind === 'done' && digest.speed !== undefined && <p class="digest">{words.took(digest.speed)}</p>}
        {(digest.kind === 'cancelled' || digest.kind === 'failed') && (
          <p class={digest.kind === 'failed' ? 'digest error' : 'digest'}>
            {words[digest.kind]}{' '}
            <button type="button" onClick={onAgain}>
              {words.again}
            </button>
          </p>
        )}
      </div>
    </>
  );
}
