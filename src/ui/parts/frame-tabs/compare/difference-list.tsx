import type { Cause, Difference } from '../../../../diagnosis/index.ts';
import { formatBytes } from '../../../../notation/index.ts';
import type { Compared } from '../../../../workbench/index.ts';
import { characters } from '../../../../workbench/index.ts';
import { useWords } from '../../words.ts';

/** Longest run of bytes printed whole; of a longer one the beginning. */
const WHOLE = 16;

/** Why, and what to do. */
export function CauseLine({ cause }: { cause: Cause }) {
  const words = useWords('compare');
  const { why, todo } = words.causeWords(cause);
  return (
    <p class="cause">
      {why} {todo && <span class="soft">{todo}</span>}
    </p>
  );
}

/** Each field that differs: what was built, what was sent, the likely cause, and what to do. */
export function DifferenceList({ comparison, mine, theirs, ascii }: Compared) {
  const words = useWords('compare');
  const labelOf = useLabel();
  return (
    <>
      <h3 id="differences">{words.list}</h3>
      <ol class="differences edges stack" aria-labelledby="differences">
        {comparison.differences.map((difference) => {
          const place = difference.mine ?? difference.theirs;
          return (
            <li
              key={`${difference.mine?.from} ${difference.theirs?.from}`}
              data-kind={place?.kind}
              data-from={difference.mine?.from}
              data-to={difference.mine?.to}
            >
              <b>{labelOf(place?.name ?? '')}</b>{' '}
              <span class="mono">
                {textOf(mine, difference.mine, ascii) ?? words.none} →{' '}
                {textOf(theirs, difference.theirs, isAscii(comparison)) ?? words.none}
              </span>
              {valuesOf(difference)}
              <CauseLine cause={difference.cause} />
            </li>
          );
        })}
      </ol>
    </>
  );
}

/** What a field of the compared frames is called. */
export function useLabel(): (name: string) => string {
  const { before } = useWords('compare');
  const { labels } = useWords('page');
  return (name) => (name === 'before' ? before : (labels[name] ?? name));
}

const isAscii = ({ transport }: Compared['comparison']) => transport === 'ascii';

function textOf(bytes: Uint8Array, place: Difference['mine'], ascii: boolean): string | undefined {
  if (place === undefined) return undefined;
  const slice = bytes.subarray(place.from, place.to);
  const head = slice.subarray(0, WHOLE);
  return (ascii ? characters(head) : formatBytes(head)) + (slice.length > WHOLE ? ' …' : '');
}

/** The numbers that the bytes make, where they make numbers that people speak of in decimal. */
function valuesOf({ mine, theirs }: Difference) {
  if (mine?.value === undefined || theirs?.value === undefined || mine.kind === 'function') return null;
  if (mine.value === theirs.value) return null;
  return <span class="soft">{` (${mine.value} → ${theirs.value})`}</span>;
}
