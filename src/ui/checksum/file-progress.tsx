import type { ChecksumView } from '../../store/index.ts';
import type { ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';

/** How far the bytes are read, and how fast. */
export function FileProgress({ view }: ViewProps<ChecksumView>) {
  const words = useWords('checksum');
  const digest = view.digest.value;
  return (
    <>
      {digest.kind === 'computing' && (
        <p class="digest in-row">
          <progress aria-label={words.computing} value={digest.done} max={Math.max(1, digest.size)} />{' '}
          {words.progress(digest.done, digest.size, digest.speed)}{' '}
          <button type="button" onClick={view.cancel}>
            {words.cancel}
          </button>
        </p>
      )}
      {/* How far it is would be read out several times a second. */}
      <div aria-live="polite">
        {digest.kind === 'done' && digest.speed !== undefined && (
          <p class="digest in-row">{words.took(digest.speed)}</p>
        )}
        {(digest.kind === 'cancelled' || digest.kind === 'failed') && (
          <p class={digest.kind === 'failed' ? 'digest error' : 'digest'}>
            {words[digest.kind]}{' '}
            <button type="button" onClick={view.again}>
              {words.again}
            </button>
          </p>
        )}
      </div>
    </>
  );
}
