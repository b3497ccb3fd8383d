import { useState } from 'preact/hooks';
import type { TraceView } from '../../../store/index.ts';
import { useWords } from '../../parts/words.ts';

/** What a tab beside the list is given. */
export interface TraceTabProps {
  readonly of: TraceView<File>;
  /** Whether it is the one that is open: nothing is counted for another. */
  readonly open: boolean;
  /** Brings the person to the list. */
  readonly toRows: () => void;
}

/** Stands in a tab until what it shows has been counted. */
export const Counting = () => (
  <p class="said" role="status">
    {useWords('trace').tabs.counting}
  </p>
);

/** Says, beside a filter, that it changes nothing of what is counted. */
export function OfWholeLog({ of }: Pick<TraceTabProps, 'of'>) {
  const { tabs: words } = useWords('trace');
  return of.filter.value.trim() !== '' && <p class="said">{words.ofWholeLog}</p>;
}

/** Rows that are drawn at first, and with each press of the button. */
const SOME = 100;

/** Of many rows the first ones, and a button that shows more of them. */
export function useSome<Row>(rows: readonly Row[]) {
  const { tabs: words } = useWords('trace');
  const [most, setMost] = useState(SOME);
  const left = Math.min(SOME, rows.length - most);
  return {
    shown: rows.slice(0, most),
    more: left > 0 && (
      <button type="button" onClick={() => setMost(most + SOME)}>
        {words.more(left)}
      </button>
    ),
  };
}
