import { plainWords } from '../notation/index.ts';
import type { Name } from './code.ts';
import type { ProgramNote } from './plan.ts';
import type { Role } from './syntax.ts';

/** How words become one name: `start_address`, `startAddress`, `StartAddress`, `START_ADDRESS`. */
export type NameStyle = keyof typeof styles;

const capital = (word: string): string => word.charAt(0).toUpperCase() + word.slice(1);

/** Two digits that would run into each other are kept apart. */
const joined = (words: readonly string[]): string =>
  words.reduce((text, word) => (/\d$/.test(text) && /^\d/.test(word) ? `${text}_${word}` : text + word), '');

const styles = {
  snake: (words: readonly string[]) => words.join('_'),
  camel: (words: readonly string[]) => joined(words.map((word, index) => (index === 0 ? word : capital(word)))),
  pascal: (words: readonly string[]) => joined(words.map(capital)),
  constant: (words: readonly string[]) => words.join('_').toUpperCase(),
} as const satisfies Readonly<Record<string, (words: readonly string[]) => string>>;

/** What is named. Names of one kind have one style. */
export type NameKind = Role | 'type';

/** What a language takes for a name, as data. */
export interface NameRules {
  readonly styles: Readonly<Record<NameKind, NameStyle>>;
  /** Keywords and names of what stands in its library, which a name may not be. */
  readonly reserved: readonly string[];
  /** Forms of names that are kept besides, of capitals. */
  readonly reservedForms?: RegExp | undefined;
  /** What stands in front of names of a kind, such as `FB_`. */
  readonly prefixes?: Readonly<Partial<Record<NameKind, string>>> | undefined;
  /** Whether `Len` and `len` are one name; `false` by default. */
  readonly ignoresCase?: boolean | undefined;
  /** Most characters; without a limit by default. */
  readonly most?: number | undefined;
  /** What a name of the user's own must be to stay as it is; by default a letter, then letters, digits and `_`. */
  readonly valid?: RegExp | undefined;
}

const VALID = /^[A-Za-z]\w*$/;

/** What is added to a name that is reserved, by what is named. */
const ADDED: Readonly<Record<NameKind, string>> = {
  routine: 'routine',
  variable: 'value',
  constant: 'constant',
  table: 'table',
  type: 'type',
};

/**
 * The names of one program in one language: the same words always get the same name, and others another one. `own` are names
 * of the user's, by the name that would stand there otherwise.
 */
export class Names {
  readonly notes: ProgramNote[] = [];
  readonly #rules: NameRules;
  readonly #own: ReadonlyMap<string, string>;
  readonly #given = new Map<string, string>();
  readonly #taken: Set<string>;

  constructor(rules: NameRules, own?: Readonly<Record<string, string>>) {
    this.#rules = rules;
    this.#own = new Map(Object.entries(own ?? {}));
    this.#taken = new Set(rules.reserved.map((one) => this.#key(one)));
  }

  /** The name for words; of any text, the letters and digits of it. As a `Syntax` takes it. */
  readonly of = (words: Name, kind: NameKind): string => {
    const key = `${kind} ${words}`;
    const found = this.#given.get(key);
    if (found !== undefined) return found;
    const usual = this.#free(kind, this.#words(kind, words));
    const own = this.#own.get(usual);
    const given = own === undefined ? usual : this.#ownName(kind, own);
    this.#taken.add(this.#key(given));
    this.#given.set(key, given);
    return given;
  };

  /** Keeps a name that stands in texts of the target: it is the usual one, and no name of the user's replaces it. */
  keep(words: Name, kind: NameKind): void {
    const usual = this.#free(kind, this.#words(kind, words));
    const own = this.#own.get(usual);
    if (own !== undefined) this.notes.push({ code: 'name-changed', from: own, to: usual });
    this.#taken.add(this.#key(usual));
    this.#given.set(`${kind} ${words}`, usual);
  }

  readonly #key = (one: string): string => (this.#rules.ignoresCase ? one.toLowerCase() : one);

  /** Words that make a name: it begins with a letter. */
  #words(kind: NameKind, text: string): readonly string[] {
    const words = plainWords(text).split(' ');
    const [first = ''] = words;
    if (first === '') return [ADDED[kind]];
    return /^\d/.test(first) ? [ADDED[kind], ...words] : words;
  }

  /** A name that is neither reserved nor taken. */
  #free(kind: NameKind, words: readonly string[]): string {
    const { prefixes, reservedForms } = this.#rules;
    const style = (all: readonly string[]) => (prefixes?.[kind] ?? '') + styles[this.#rules.styles[kind]](all);
    const { most = Number.POSITIVE_INFINITY } = this.#rules;
    const cut = (more: readonly string[]): string => {
      let kept = words;
      while (style([...kept, ...more]).length > most && kept.length > 1) kept = kept.slice(0, -1);
      const whole = style([...kept, ...more]);
      return whole.length > most ? style([(kept[0] ?? '').slice(0, most - style(more).length - 1), ...more]) : whole;
    };
    const plain = cut([]);
    const formed = reservedForms?.test(plain.toUpperCase()) ?? false;
    if (!formed && !this.#taken.has(this.#key(plain))) return plain;
    const added = cut([words.at(-1) === ADDED[kind] ? 'number' : ADDED[kind]]);
    const isReserved = formed || this.#rules.reserved.some((one) => this.#key(one) === this.#key(plain));
    if (isReserved && !this.#taken.has(this.#key(added))) return added;
    for (let number = 2; ; number++) {
      const numbered = cut([String(number)]);
      if (!this.#taken.has(this.#key(numbered))) return numbered;
    }
  }

  /** A name of the user's own: as it is if it may stand there, else the nearest that may. */
  #ownName(kind: NameKind, own: string): string {
    const { valid = VALID, most = Number.POSITIVE_INFINITY } = this.#rules;
    const formed = this.#rules.reservedForms?.test(own.toUpperCase()) ?? false;
    if (valid.test(own) && !formed && own.length <= most && !this.#taken.has(this.#key(own))) return own;
    const to = this.#free(kind, this.#words(kind, own));
    this.notes.push({ code: 'name-changed', from: own, to });
    return to;
  }
}
