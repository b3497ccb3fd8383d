import { Component, type VNode } from 'preact';
import type { ReferenceWords } from '../../words/index.ts';
import type { Section } from './entry.tsx';
import { addressOf, searchOf } from './search-address.ts';
import './reference.css';
import { finder } from './search.ts';
import { sectionsOf } from './sections.ts';
import { headingOf, TablePanel } from './table-panel.tsx';

interface ReferenceProps {
  readonly text: ReferenceWords;
  readonly sections: readonly Section[];
}

/** Browsers limit how often the address may change, so that it follows typing at a little distance. */
const ADDRESS_DELAY = 250;
/** The id of the search field. */
const FIELD = 'reference-search';

let opened: VNode | undefined;

/** The view in these words. Its tables are worked out once: Back finds them as they were. */
export function openReference(text: ReferenceWords): VNode {
  opened ??= <ReferenceView text={text} sections={sectionsOf(text)} />;
  return opened;
}

/** The tables of the specification, searched as one types; what is searched for stands in the address. */
class ReferenceView extends Component<ReferenceProps, { search: string }> {
  override state = { search: searchOf(location.hash) };
  private pending: ReturnType<typeof setTimeout> | undefined;
  private titleBefore = '';

  override componentDidMount() {
    this.titleBefore = document.title;
    document.title = this.props.text.title;
    addEventListener('popstate', this.takeAddress);
    addEventListener('hashchange', this.takeAddress);
    addEventListener('pagehide', this.follow);
  }

  override componentWillUnmount() {
    clearTimeout(this.pending);
    document.title = this.titleBefore;
    // A frame opened far down these tables begins at its top.
    scrollTo(0, 0);
    removeEventListener('popstate', this.takeAddress);
    removeEventListener('hashchange', this.takeAddress);
    removeEventListener('pagehide', this.follow);
  }

  private readonly takeAddress = () => {
    this.drop();
    this.setState({ search: searchOf(location.hash) });
  };

  private readonly search = (search: string) => {
    this.setState({ search });
    clearTimeout(this.pending);
    this.pending = setTimeout(this.follow, ADDRESS_DELAY);
  };

  /** The button goes with what it clears, so the focus goes on to the field. */
  private readonly clear = () => {
    this.search('');
    document.getElementById(FIELD)?.focus();
  };

  /** Brings the address up to what is typed: at a pause, and before a link is followed, so that Back finds it. */
  private readonly follow = () => {
    if (this.pending === undefined) return;
    this.drop();
    history.replaceState(null, '', addressOf(this.state.search));
  };

  private drop() {
    clearTimeout(this.pending);
    this.pending = undefined;
  }

  render() {
    const { text, sections } = this.props;
    const { search } = this.state;
    const finds = finder(search);
    const found = sections.map((section) => ({ section, entries: section.entries.filter(finds) }));
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
                <strong>{text.nothing(search.trim())}</strong>
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
