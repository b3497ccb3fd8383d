import { useState } from 'preact/hooks';
import { disabledFor } from '../../kit/disabled-for.ts';

interface PagesWords {
  readonly earlier: string;
  readonly later: string;
  readonly atFirst: string;
  readonly atLast: string;
  readonly pageOf: (first: number, last: number, all: number) => string;
}

/** Of many items those of one page, which begins at `start` and ends before `end`, and what turns the pages if there are several. */
export function usePages(count: number, size: number, words: PagesWords) {
  const [wanted, setPage] = useState(0);
  const last = Math.max(0, Math.ceil(count / size) - 1);
  const page = Math.min(wanted, last);
  const [start, end] = [page * size, Math.min(count, (page + 1) * size)];
  return {
    start,
    end,
    turning: last > 0 && (
      <p class="pages in-row">
        <button
          type="button"
          {...disabledFor(page === 0 ? words.atFirst : undefined)}
          onClick={() => setPage(page - 1)}
        >
          {words.earlier}
        </button>{' '}
        {words.pageOf(start + 1, end, count)}{' '}
        <button
          type="button"
          {...disabledFor(page === last ? words.atLast : undefined)}
          onClick={() => setPage(page + 1)}
        >
          {words.later}
        </button>
      </p>
    ),
    /** Goes to the page of an item. */
    show: (item: number) => setPage(Math.max(0, Math.floor(item / size))),
  };
}
