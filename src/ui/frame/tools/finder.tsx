import { Component } from 'preact';
import { codeRange, diagnosticSubFunctions, functionCodes, meiTypes } from '../../../modbus/index.ts';
import { formatHex, readNumber } from '../../../notation/index.ts';
import type { ToolWords } from '../../../words/index.ts';
import { words as pageWords } from '../../parts/page-words.ts';
import { draft, step } from '../../parts/store.ts';

/** Something that can be found, and the texts that choose it. */
interface Found {
  readonly name: string;
  readonly texts: Readonly<Record<string, string>>;
}

/** Longest list of finds. */
const MOST = 8;

const digits = (code: number) => formatHex(code, 2).slice(2);

const everything: readonly (Found & { readonly code: number })[] = [
  ...functionCodes.map(({ code, name }) => ({
    code,
    name: `${digits(code)} ${name}`,
    texts: { functionCode: String(code) },
  })),
  ...meiTypes.map(({ meiType, name }) => ({
    code: 0x2b,
    name: `2B/${digits(meiType)} ${name}`,
    texts: { functionCode: '43', meiType: String(meiType) },
  })),
  ...diagnosticSubFunctions.map(({ code, name }) => ({
    code: 0x08,
    name: `08/${digits(code)} ${name}`,
    texts: { functionCode: '8', subFunction: String(code) },
  })),
];

/** The functions, sub-functions and MEI types that a name or a code in decimal or hexadecimal may mean. */
export function findFunctions(query: string): Found[] {
  const text = query.trim().toLowerCase();
  if (text === '') return [];
  const asTyped = readNumber(text);
  const asHex = /^[0-9a-f]{1,2}$/.test(text) ? Number.parseInt(text, 16) : undefined;
  const codes = [asTyped, asHex].filter((code) => code !== undefined && code > 0 && code <= 0x7f);
  const named = everything.filter(({ code, name }) => codes.includes(code) || name.toLowerCase().includes(text));
  const others = codes
    .filter((code) => code !== undefined && codeRange(code) !== 'public')
    .map((code = 0) => ({
      name: `${digits(code)}, ${code}: ${pageWords.page.codeRanges[codeRange(code)]}`,
      texts: { functionCode: String(code) },
    }));
  // A code that was typed comes before a name that happens to hold its digits.
  const rank = ({ code }: { readonly code: number }) => (codes.includes(code) ? 0 : 1);
  return [...named.toSorted((a, b) => rank(a) - rank(b)), ...others].slice(0, MOST);
}

/** Finds a function by typing; Enter takes the first. */
export class Finder extends Component<{ words: ToolWords }, { query?: string }> {
  private choose({ texts }: Found): void {
    const { value: current } = draft;
    this.setState({ query: '' });
    step({ ...current, texts: { ...current.texts, ...texts } });
  }

  render() {
    const { words } = this.props;
    const { query = '' } = this.state;
    const found = findFunctions(query);
    return (
      <search>
        <input
          type="search"
          aria-label={words.find}
          placeholder={words.findHint}
          autocomplete="off"
          spellcheck={false}
          value={query}
          onInput={({ currentTarget }) => this.setState({ query: currentTarget.value })}
          onKeyDown={(event) => {
            const [first] = found;
            if (event.key !== 'Enter' || first === undefined) return;
            event.preventDefault();
            this.choose(first);
          }}
        />
        {query.trim() !== '' && (
          <ul class="found" aria-label={words.found(found.length)}>
            {found.map((each) => (
              <li key={each.name}>
                <button type="button" onClick={() => this.choose(each)}>
                  {each.name}
                </button>
              </li>
            ))}
            {found.length === 0 && <li>{words.found(0)}</li>}
          </ul>
        )}
      </search>
    );
  }
}
