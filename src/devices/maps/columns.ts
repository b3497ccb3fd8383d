import { readAddressCell } from './address-cell.ts';
import { areDevices } from './address-style.ts';
import { areUnits, fits, hasWords, isFilled, shownByCells } from './cell-kinds.ts';
import type { Block } from './header-rows.ts';
import { headerMatches } from './header-words.ts';
import { type ColumnReason, isSingle, type MapColumn, type Meaning, meanings } from './meaning.ts';
import { readScaleCell } from './scale-cell.ts';

/** Rows whose cells are looked at to understand a column. */
const SAMPLE = 300;
/** No map has more columns that mean something; others are left alone. */
const MOST = 400;
/** The share of filled cells that must fit what the header says. */
const LEAST: Partial<Record<Meaning, number>> = {
  names: 0.3,
  'other-name': 0.5,
  description: 0.3,
  other: 0,
  model: 0,
  table: 0.7,
  function: 0.8,
  access: 0.7,
  address: 0.4,
  number: 0.4,
  group: 0.5,
  unit: 0.7,
  words: 0.5,
};
const USUAL_LEAST = 0.6;
/** Meanings that hardly any cell of another one fits. */
const STRICT: ReadonlySet<Meaning> = new Set(['function', 'table', 'access', 'type', 'order', 'address', 'number']);

interface Candidate {
  readonly at: number;
  readonly meaning: Meaning;
  readonly why: ColumnReason;
  readonly score: number;
}

/**
 * The columns of a table with what each is taken for; `headed` says that its header was made of keys. `answered` says what a person has
 * chosen for some of them, `known` what the headers of a named format mean.
 */
export function columnsOf(
  { headers, rows }: Block,
  headed: boolean,
  answered: (at: number) => string | undefined,
  known?: ReadonlyMap<string, Meaning>,
): readonly MapColumn[] {
  const width = rows.reduce((most, { cells }) => Math.max(most, cells.length), headers.length);
  const step = Math.max(1, Math.floor(rows.length / SAMPLE));
  const sample = rows.filter((_, place) => place % step === 0);
  const cells = Array.from({ length: Math.min(width, MOST) }, (_, at) =>
    sample.map((row) => row.cells[at]?.trim() ?? '').filter(isFilled),
  );
  const chosen = new Map<number, Omit<Candidate, 'at' | 'score'>>();
  const taken = new Set<Meaning>();
  const choose = (at: number, meaning: Meaning, why: ColumnReason) => {
    chosen.set(at, { meaning, why });
    if (isSingle(meaning)) taken.add(meaning);
  };
  for (let at = 0; at < cells.length; at++) {
    const answer = meanings.find((meaning) => meaning === answered(at));
    const meant = answer ? undefined : known?.get(headers[at] ?? '');
    if (answer) choose(at, answer, 'answer');
    else if (meant) choose(at, meant, 'header');
  }
  const candidates = cells.flatMap((texts, at) => candidatesOf(at, headers[at] ?? '', texts, sample.length));
  for (const { at, meaning, why, score } of candidates.sort((a, b) => b.score - a.score || a.at - b.at)) {
    if (chosen.has(at)) continue;
    if (!isSingle(meaning) || !taken.has(meaning)) choose(at, meaning, why);
    // The same number in another form.
    else if (meaning === 'address' && !taken.has('number') && !mayBeOther(headers[at] ?? '', cells[at] ?? []))
      choose(at, 'number', why);
    // The same in another language, or a technical id.
    else if (meaning === 'name' && score > 25) choose(at, 'other-name', why);
  }
  const free = () =>
    cells
      .map((texts, at) => ({ at, texts }))
      .filter(
        ({ at, texts }) =>
          (!chosen.has(at) || (chosen.get(at)?.meaning === 'other' && headers[at] === '')) && texts.length > 0,
      );
  if (!taken.has('address') && !taken.has('number')) {
    const best = mostBy(free(), ({ texts }) => addressLikeness(texts));
    // Keys of objects say what their values are: other numbers of theirs are not addresses.
    const devices = free().find(({ texts }) => areDevices(texts));
    if (devices) choose(devices.at, 'address', 'cells');
    else if (best && !headed) choose(best.at, 'address', 'cells');
    else fallBack(['index', 'bit'], 'address');
  }
  if (!taken.has('type')) {
    const codes = free().find(
      ({ at, texts }) =>
        headerMatches(headers[at] ?? '').some(({ meaning, strength }) => meaning === 'type' && strength >= 2) &&
        new Set(texts).size <= 12 &&
        texts.every((text) => text.length < 40),
    );
    if (codes) choose(codes.at, 'type', 'header');
  }
  if (headers.length === 0 && !taken.has('factor')) {
    const scale = free().find(({ texts }) => isScale(texts));
    if (scale) choose(scale.at, 'factor', 'cells');
  }
  if (!taken.has('name')) fallBack(['other-name'], 'name');
  const different = (at: number) => new Set(cells[at]).size;
  const columnOf = (meaning: Meaning) =>
    Array.from(chosen).find(([, own]) => own.meaning === meaning && own.why !== 'answer')?.[0];
  const [named, described] = [columnOf('name'), columnOf('description')];
  // What nearly all rows have in common is the name of a group: the other column of texts names them.
  const most = described === undefined ? 0 : different(described);
  if (named !== undefined && described !== undefined && most > 1 && different(named) <= Math.max(1, most / FEW_NAMES)) {
    choose(described, 'name', 'texts');
    chosen.set(named, { meaning: taken.has('group') ? 'other-name' : 'group', why: 'cells' });
  }
  if (!taken.has('name') && described !== undefined && cells[described]?.every((text) => text.length < SHORT)) {
    choose(described, 'name', 'texts');
  }
  if (!taken.has('name')) {
    const best = mostBy(
      free().filter(
        ({ texts }) => share(texts, hasWords) > 0.5 || (headers.length === 0 && share(texts, fits.name) > 0.8),
      ),
      ({ texts }) => (new Set(texts).size / texts.length) * Math.min(1, texts.length / sample.length),
    );
    if (best) choose(best.at, 'name', 'texts');
    else fallBack(['description', 'group'], 'name');
  }
  if (headers.length === 0 && !taken.has('group') && sample.length > 8) {
    const group = free().find(
      ({ texts }) =>
        share(texts, fits.group) === 1 &&
        texts.length > sample.length * 0.8 &&
        new Set(texts).size < texts.length / 3 &&
        share(texts, (text) => text.length > 2) > 0.9,
    );
    if (group) choose(group.at, 'group', 'cells');
  }
  function fallBack(from: readonly Meaning[], to: Meaning) {
    const found = from.flatMap((meaning) =>
      Array.from(chosen).filter(([, own]) => own.meaning === meaning && own.why !== 'answer'),
    )[0];
    if (found) choose(found[0], to, 'header');
  }
  return Array.from({ length: width }, (_, at) => ({
    header: headers[at] ?? '',
    ...(chosen.get(at) ?? { meaning: 'other', why: 'unknown' }),
  }));
}

/** So many times as many descriptions as names show that the names are those of groups. */
const FEW_NAMES = 8;
/** A description that may stand for a name. */
const SHORT = 80;

/** What a column of names loses that is blank in most rows: another one may have them. */
const SPARSE = -15;
const FEW = 0.3;

/** What a column may be; `rows` of its cells were looked at, of which `texts` are filled. */
function candidatesOf(at: number, header: string, texts: readonly string[], rows: number): Candidate[] {
  const found: Candidate[] = [];
  const matches = headerMatches(header);
  const mayBe = new Set(matches.map(({ meaning }) => meaning));
  for (const { meaning, strength } of matches) {
    const fit = texts.length === 0 ? 0.5 : share(texts, fits[meaning]);
    if (fit >= (texts.length === 0 ? 0 : (LEAST[meaning] ?? USUAL_LEAST)) && suits(meaning, texts, mayBe))
      found.push({
        at,
        meaning,
        why: 'header',
        score:
          strength * 10 +
          fit * 4 +
          (STRICT.has(meaning) ? 5 : 0) +
          (/device|slave|server|ger[aä]t/i.test(header) ? 2 : 0) -
          (texts.length === 0 ? 9 : 0) +
          (meaning === 'name' && texts.length < rows * FEW ? SPARSE : 0),
      });
  }
  if (texts.length > 0)
    for (const [meaning, least, test] of shownByCells) {
      const fit = share(texts, test);
      if (fit >= least) found.push({ at, meaning, why: 'cells', score: 12 + 6 * fit });
    }
  // A column for each model, with a mark where the model has the register.
  if (header !== '' && found.length === 0 && texts.length > 0 && texts.every(isMark))
    found.push({ at, meaning: 'model', why: 'cells', score: 14 });
  if (areUnits(texts, header === '')) found.push({ at, meaning: 'unit', why: 'cells', score: 15 });
  return found;
}

/** Whether a column beside that of the addresses is rather a length, or what is added to values: it is called so, and its numbers repeat. */
const mayBeOther = (header: string, texts: readonly string[]): boolean =>
  headerMatches(header).some(
    ({ meaning, strength }) => (meaning === 'offset' || meaning === 'words') && strength >= 2,
  ) &&
  (texts.some((text) => /^[-−]|[.,]\d/.test(text)) || new Set(texts).size < texts.length || texts.length < 2);

const isMark = (text: string): boolean => /^[xX✓✔●•√◯○]$/.test(text);

/** What the cells of a column must be as a whole. */
function suits(meaning: Meaning, texts: readonly string[], mayBe: ReadonlySet<Meaning>): boolean {
  switch (meaning) {
    case 'index':
      return texts.every(
        (text, place) => place === 0 || Number.parseInt(text, 10) >= Number.parseInt(texts[place - 1] ?? '', 10),
      );
    case 'factor':
      return !(mayBe.has('exponent') && areExponents(texts)) && !(mayBe.has('decimals') && areDecimals(texts));
    case 'decimals':
      return !mayBe.has('factor') || areDecimals(texts);
    case 'exponent':
      return areExponents(texts);
    case 'bit':
      return texts.length > 0;
    // A first letter stands for hardly any value: lengths such as 16 and 32 are sizes in bits.
    case 'words':
      return !texts.some((text) => /^(?:16|32|48|64)$/.test(text)) || texts.some((text) => /^[1-4]$/.test(text));
    case 'bit-size':
      return texts.some((text) => Number.parseInt(text, 10) >= 8);
    default:
      return true;
  }
}

/** Small whole numbers, 0 among them or some but 1: a precision of 2 is no factor. */
const areDecimals = (texts: readonly string[]): boolean =>
  texts.every((text) => /^[0-6]$/.test(text)) && texts.some((text) => text !== '1');

/** Small whole numbers, some of them negative. Where 1 stands for no scale, and 0 does not, −1 turns the sign. */
const areExponents = (texts: readonly string[]): boolean =>
  texts.every((text) => /^[-−+]?\d$/.test(text)) &&
  texts.some((text) => /^[-−]/.test(text)) &&
  !(texts.every((text) => /^[-−]?1$/.test(text)) && texts.includes('1'));

const share = (texts: readonly string[], test: (text: string) => boolean): number =>
  texts.length === 0 ? 0 : texts.filter(test).length / texts.length;

function mostBy<T>(list: readonly T[], score: (one: T) => number): T | undefined {
  let [best, found] = [0, undefined] as [number, T | undefined];
  for (const one of list) {
    const own = score(one);
    if (own > best) [best, found] = [own, one];
  }
  return found;
}

/** How much a column without a header looks like addresses: whole numbers, mostly different and rising. 0 if it does not. */
function addressLikeness(texts: readonly string[]): number {
  const numbers = texts.flatMap(
    (text) => readAddressCell(text)?.number ?? readAddressCell(text, { hex: true })?.number ?? [],
  );
  if (numbers.length < texts.length * 0.8 || texts.length === 0) return 0;
  const different = new Set(numbers).size / numbers.length;
  const rising =
    numbers.filter((number, place) => place > 0 && number > (numbers[place - 1] ?? 0)).length /
    Math.max(1, numbers.length - 1);
  const prefixed = texts.filter((text) => /^0x|^[34]\d{4}$/i.test(text)).length / texts.length;
  return different < 0.3 && numbers.length > 3
    ? 0
    : different + rising + prefixed + Math.max(...numbers.slice(0, 500)) / 1e6;
}

/** Few different numbers, most of them powers of ten, and not all of them small whole ones. */
function isScale(texts: readonly string[]): boolean {
  const scales = texts.map((text) => readScaleCell(text)?.number);
  const powers = scales.filter(
    (scale) => scale !== undefined && Number.isInteger(Math.round(1e6 * Math.log10(Math.abs(scale))) / 1e6),
  );
  return (
    powers.length > texts.length * 0.9 &&
    new Set(scales).size <= 20 &&
    scales.some((scale) => scale !== undefined && scale !== 1)
  );
}
