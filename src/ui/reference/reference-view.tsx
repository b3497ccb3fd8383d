import { useMemo } from 'preact/hooks';
import { AddressedView } from '../../store/index.ts';
import { finder, type ReferenceSubject } from '../../workbench/index.ts';
import { disabledFor } from '../kit/disabled-for.ts';
import { SearchBox } from '../kit/search-box.tsx';
import { Table } from '../kit/table.tsx';
import { page } from '../parts/store.ts';
import { useView } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import { About } from './about-page.tsx';
import { numberingEntries, unitEntries } from './addresses.tsx';
import { exceptionEntries, rangeEntries } from './codes.tsx';
import { type Entry, type Say, searchableOf } from './entry.tsx';
import { functionEntries, meiEntries, subFunctionEntries } from './functions.tsx';
import { limitEntries, sizeEntries } from './limits.tsx';
import { misprintEntries, openEntries, troubleEntries } from './notes.tsx';
import './reference.css';

/** The widths of the columns, which stay where they are while a search takes rows away. */
const WIDTHS: Readonly<Record<ReferenceSubject, string>> = {
  functions: '4.5rem 10.5rem 6.5rem 5.5rem 1fr 4.5rem',
  troubles: '13rem 1fr 12rem 9.5rem',
  exceptions: '5rem 20rem 1fr 6rem',
  subFunctions: '6rem 18rem 1fr 6rem',
  meiTypes: '6rem 18rem 1fr 6rem',
  numbering: '9rem 1fr 13.5rem 9.5rem 6.5rem 6.5rem',
  units: '9rem 7rem 1fr 8rem',
  sizes: '5rem 9rem 1fr 10.5rem',
  limits: '17rem 6rem 1fr 8rem 8.5rem 5rem',
  ranges: '10rem 13rem 1fr 6rem',
  open: '17rem 1fr 8.5rem',
  misprints: '13rem 12rem 12rem 1fr 6rem',
};

/** The id of the search field. */
const FIELD = 'reference-search';

/** The rows of all tables, in the order in which they are shown. */
const entriesOf: Readonly<Record<ReferenceSubject, (say: Say) => readonly Entry[]>> = {
  functions: functionEntries,
  troubles: troubleEntries,
  exceptions: exceptionEntries,
  subFunctions: subFunctionEntries,
  meiTypes: meiEntries,
  numbering: numberingEntries,
  units: unitEntries,
  sizes: sizeEntries,
  limits: limitEntries,
  ranges: rangeEntries,
  open: openEntries,
  misprints: misprintEntries,
};

/** A table's rows, with what a search looks through in each. */
function tableOf(subject: ReferenceSubject, say: Say) {
  const others = say.text.foundBy[subject];
  const rows = entriesOf[subject](say).map((entry) => ({ entry, searchable: searchableOf(entry, others) }));
  return { subject, rows };
}

const idOf = (subject: ReferenceSubject) => `table-${subject}`;

/** A search as it is repeated in a sentence. */
const shortly = (text: string) => (text.length > 100 ? `${text.slice(0, 100)}…` : text);

/** The tables of the specification, searched while typing; the address has the search. */
export function ReferenceView() {
  const text = useWords('reference');
  const words = useWords('page');
  const about = useWords('about');
  const tables = useMemo(
    () => (Object.keys(entriesOf) as ReferenceSubject[]).map((subject) => tableOf(subject, { text, page: words })),
    [text, words],
  );
  const { shown, change } = useView(
    text.title,
    () =>
      new AddressedView(
        page,
        'reference',
        (parts) => ({ search: parts.get('search') ?? '' }),
        (typed) => typed,
      ),
  );
  const { search } = shown.value;
  const finds = finder(search);
  const found = tables.map((table) => ({ ...table, rows: table.rows.filter(({ searchable }) => finds(searchable)) }));
  const count = found.reduce((sum, { rows }) => sum + rows.length, 0);
  const all = tables.reduce((sum, { rows }) => sum + rows.length, 0);
  return (
    <main class="reference">
      <div class="rail">
        <SearchBox
          id={FIELD}
          label={text.search}
          text={search}
          hint={text.searchHint}
          found={text.shown(count, all)}
          onText={(typed) => change({ search: typed })}
          onLeave={() => page.address.now()}
        />
        <nav aria-label={text.tables}>
          <ul>
            {found.map(({ subject, rows }) => (
              <li key={subject}>
                <button
                  type="button"
                  {...disabledFor(rows.length === 0 ? text.nothing(shortly(search.trim())) : undefined)}
                  onClick={() => document.getElementById(idOf(subject))?.focus()}
                >
                  {text.subjects[subject]} <small class="mono">{rows.length}</small>
                </button>
              </li>
            ))}
            <li>
              <button
                type="button"
                {...disabledFor(search.trim() === '' ? undefined : about.hidden)}
                onClick={() => document.getElementById('about')?.focus()}
              >
                {about.title}
              </button>
            </li>
          </ul>
        </nav>
      </div>
      <div class="tables stack">
        {count === 0 && (
          <section class="panel">
            <p>
              <strong>{text.nothing(shortly(search.trim()))}</strong>
            </p>
            <p class="introduction soft">{text.nothingHint}</p>
            <button
              type="button"
              onClick={() => {
                change({ search: '' });
                // The button goes with what it clears, so the focus goes on to the field.
                document.getElementById(FIELD)?.focus();
              }}
            >
              {text.clear}
            </button>
          </section>
        )}
        {found.map(
          ({ subject, rows }) =>
            rows.length > 0 && (
              <section
                key={subject}
                class="panel"
                aria-labelledby={idOf(subject)}
                data-subject={subject}
                style={{ '--columns': WIDTHS[subject] }}
              >
                {/* It takes the focus so that reading goes on from there. */}
                <h2 id={idOf(subject)} tabIndex={-1}>
                  {text.subjects[subject]}
                </h2>
                <p class="introduction soft">{text.introductions[subject]}</p>
                <Table
                  labelledBy={idOf(subject)}
                  columns={text.columns[subject].map((name, at) => ({
                    name,
                    cell: ({ entry }: (typeof rows)[number]) => entry.cells[at],
                  }))}
                  rows={rows}
                  keyOf={({ entry }) => entry.key}
                  narrow="cards many"
                />
              </section>
            ),
        )}
        {search.trim() === '' && <About />}
      </div>
    </main>
  );
}
