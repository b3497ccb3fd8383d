import type { VNode } from 'preact';
import { loadReferenceWords, type ReferenceWords } from '../../words/index.ts';
import { AddressedView } from '../parts/addressed-view.ts';
import { type Section, searchableOf } from './entry.tsx';
import './reference.css';
import { finder } from '../../workbench/index.ts';
import { sectionsOf } from './sections.ts';
import { headingOf, TablePanel } from './table-panel.tsx';

interface ReferenceProps {
  readonly text: ReferenceWords;
  readonly sections: readonly Section[];
}

/** The id of the search field. */
const FIELD = 'reference-search';

/** The view with its words. Its tables are made once. */
export async function load(): Promise<() => VNode> {
  const text = await loadReferenceWords();
  const sections = sectionsOf(text);
  return () => <ReferenceView text={text} sections={sections} />;
}

/** A search as it is repeated in a sentence. */
const shortly = (text: string) => (text.length > 100 ? `${text.slice(0, 100)}…` : text);

/** The tables of the specification, searched while typing; the address has the search. */
class ReferenceView extends AddressedView<ReferenceProps, { search: string }> {
  protected readonly name = 'reference';
  protected readonly title = this.props.text.title;

  protected read(query: ReadonlyMap<string, string>) {
    return { search: query.get('search') ?? '' };
  }

  protected write({ search }: { search: string }) {
    return { search };
  }

  private readonly search = (search: string) => this.change({ search });

  /** The button goes with what it clears, so the focus goes on to the field. */
  private readonly clear = () => {
    this.search('');
    document.getElementById(FIELD)?.focus();
  };

  render() {
    const { text, sections } = this.props;
    const { search } = this.state;
    const finds = finder(search);
    const found = sections.map((section) => ({
      section,
      entries: section.entries.filter((entry) => finds(searchableOf(entry))),
    }));
    const count = found.reduce((sum, { entries }) => sum + entries.length, 0);
    const all = sections.reduce((sum, { entries }) => sum + entries.length, 0);
    return (
      <main class="reference">
        <div class="rail">
          <search>
            <label for={FIELD}>{text.search}</label>
            <input
              id={FIELD}
              type="search"
              value={search}
              placeholder={text.searchHint}
              autocomplete="off"
              spellcheck={false}
              autocapitalize="off"
              onInput={({ currentTarget }) => this.search(currentTarget.value)}
              onFocusOut={this.follow}
            />
            <output for={FIELD}>{text.shown(count, all)}</output>
          </search>
          <nav aria-label={text.tables}>
            <ul>
              {found.map(({ section: { subject }, entries }) => (
                <li key={subject}>
                  <button type="button" disabled={entries.length === 0} onClick={() => headingOf(subject)?.focus()}>
                    {text.subjects[subject]} <small class="mono">{entries.length}</small>
                  </button>
                </li>
              ))}
            </ul>
          </nav>
        </div>
        <div class="tables">
          {count === 0 && (
            <section class="panel">
              <p>
                <strong>{text.nothing(shortly(search.trim()))}</strong>
              </p>
              <p class="introduction">{text.nothingHint}</p>
              <button type="button" onClick={this.clear}>
                {text.clear}
              </button>
            </section>
          )}
          {found.map(
            ({ section, entries }) =>
              entries.length > 0 && (
                <TablePanel key={section.subject} section={section} entries={entries} text={text} />
              ),
          )}
        </div>
      </main>
    );
  }
}
