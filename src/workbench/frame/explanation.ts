import {
  type FieldKind,
  fieldByName,
  type Part,
  type Problem,
  partsOf,
  type Reading,
  type Section,
  type Severity,
  Span,
  sectionOf,
  toHex,
  type Values,
} from '../../modbus/index.ts';
import { formatBinary, formatBytes } from '../../notation/index.ts';
import { characters, worst } from './characters.ts';
import type { FrameNames } from './device-names.ts';

/** What the explanation says; a language has it. */
export interface ExplanationWords {
  /** What a field is called, by its name. */
  readonly labels: Readonly<Record<string, string>>;
  readonly section: (section: Section) => string;
  /** A problem as a sentence, without its section. */
  readonly problem: (problem: Problem) => string;
  /** What a field means in its frame. */
  readonly meaning: (of: {
    readonly reading: Reading;
    readonly bytes: Uint8Array;
    readonly span: Span;
    readonly sixDigits: boolean | undefined;
  }) => string;
  /** What an item of a list means; `address` where a device does not count one for each item. */
  readonly itemMeaning: (item: {
    readonly reading: Reading;
    readonly name: string;
    readonly kind: FieldKind;
    readonly index: number;
    readonly values: Values;
    readonly address: number | undefined;
    readonly sixDigits: boolean | undefined;
  }) => string;
  /** What items of a list mean that make one value together: `count` from `index` on, at one address if `address` is given. */
  readonly itemsMeaning: (items: {
    readonly reading: Reading;
    readonly name: string;
    readonly index: number;
    readonly count: number;
    readonly address: number | undefined;
    readonly sixDigits: boolean | undefined;
  }) => string;
  /** What a field of a group means, with the values of its group. */
  readonly groupFieldMeaning: (name: string, values: Values) => string;
  /** What a byte means, `index` from 0 of `many`. */
  readonly byteMeaning: (byte: {
    readonly span: Span;
    readonly index: number;
    readonly value: number;
    readonly many: number;
  }) => string;
}

/** One line of the explanation: a field, or one item of a list. It is made of text only, so that equal lines are known as such. */
export interface ExplanationRow {
  readonly key: string;
  readonly kind: FieldKind;
  readonly from: number;
  readonly to: number;
  readonly offset: string;
  readonly hex: string;
  readonly decimal: string;
  readonly bits: string;
  readonly characters: string;
  readonly label: string;
  /** What a device calls it, with its value: a sentence, which stands before what the specification says. */
  readonly name: string;
  readonly meaning: string;
  readonly section: string;
  /** How far the line is set in: 0 for a field, 1 for an item of it or a byte of it, and so on. */
  readonly depth: number;
  /** Whether the lines of its parts follow it; `undefined` if it has none that it can do without. */
  readonly unfolded: boolean | undefined;
  readonly severity: Severity | undefined;
  /** What is wrong here, each with its section. */
  readonly problems: string;
}

/** Longest run of bytes printed whole in a line; a longer field has its items' lines below. */
const WHOLE = 8;

/** A line that is made when it is looked at: most lines of a long frame are out of sight. */
export type LazyExplanationRow = () => ExplanationRow;

/** What is explained: the frame, the words for it, and what a device calls what is in it. */
export interface Explained {
  readonly reading: Reading;
  readonly bytes: Uint8Array;
  readonly words: ExplanationWords;
  readonly names?: FrameNames | undefined;
  /** Whether the address was typed in six digits. */
  readonly sixDigits?: boolean | undefined;
}

/** Whether the line with this key is to be followed by the lines of its parts: bytes, or the registers of one value. */
export type Unfolded = (key: string) => boolean;

/** The lines that explain a frame, in the order of its bytes: one for each field and for each item of a list. */
export const explain = (of: Explained, unfolded: Unfolded = () => false): ExplanationRow[] =>
  linesOf(of, unfolded).map((line) => line());

/** The lines of `explain`, each still to be made. */
export function linesOf(of: Explained, unfolded: Unfolded = () => false): LazyExplanationRow[] {
  const folded: Folding = { ...of, unfolded };
  return of.reading.spans.flatMap((span) => {
    const parts = partsOf(of.reading, of.bytes, span);
    return parts.length === 0
      ? withBytes(folded, span, 0, fieldParts(of, span))
      : [() => rowOf(of, span, 0, fieldParts(of, span)()), ...itemLines(folded, span, parts)];
  });
}

interface Folding extends Explained {
  readonly unfolded: Unfolded;
}

/** What a line says beside its bytes. */
interface Said {
  readonly label?: string;
  readonly name?: string;
  readonly meaning: string;
  readonly section?: Section;
  readonly problems?: readonly Problem[];
}

const fieldParts =
  ({ reading, bytes, words, names, sixDigits }: Explained, span: Span) =>
  (): Said => ({
    label: words.labels[span.name] ?? span.name,
    name: names?.field(span.name) ?? '',
    meaning: words.meaning({ reading, bytes, span, sixDigits }),
    section: sectionOf(reading, span.name),
    problems: reading.problems.filter((problem) => problem.span.from === span.from || inside(problem.span, span)),
  });

const inside = (inner: Span, outer: Span) => outer.from <= inner.from && inner.to <= outer.to && inner.to > inner.from;

/** The items of a list. Those that make one value of the device stand in one line, and unfold. */
function itemLines(of: Folding, span: Span, parts: readonly Part[]): LazyExplanationRow[] {
  const lines: LazyExplanationRow[] = [];
  for (let index = 0; index < parts.length; ) {
    const [first, last] = [parts[index], parts[index + (of.names?.covers(span.name, index) ?? 1) - 1]];
    if (first === undefined) break;
    lines.push(
      ...(last === undefined || last === first
        ? partLines(of, span, first, 1)
        : valueLines(of, span, parts.slice(index, last.index + 1))),
    );
    index = (last ?? first).index + 1;
  }
  return lines;
}

/** A value of the device in several registers; under it the registers, each with its bytes. */
function valueLines(of: Folding, { name, kind }: Span, parts: readonly Part[]): LazyExplanationRow[] {
  const { reading, words, names, sixDigits } = of;
  const [{ index, span }, last] = [parts[0] as Part, parts.at(-1) as Part];
  const whole = new Span(name, kind, span.from, last.span.to);
  const said = () => ({
    name: names?.item(name, index) ?? '',
    meaning: words.itemsMeaning({
      reading,
      name,
      index,
      count: parts.length,
      address: names?.addressOf(name, index),
      sixDigits,
    }),
  });
  return unfolding(of, whole, 1, said, () =>
    parts.flatMap((part) => partLines({ ...of, names: undefined }, whole, part, 2)),
  );
}

/** An item of a list; under it the fields of a group. */
function partLines(of: Folding, { name, kind }: Span, part: Part, depth: number): LazyExplanationRow[] {
  const { reading, words, names, sixDigits } = of;
  const { index, span, values, parts } = part;
  const said = () => ({
    name: names?.item(name, index) ?? '',
    meaning: words.itemMeaning({
      reading,
      name,
      kind: fieldByName(reading, name)?.kind ?? kind,
      index,
      values,
      address: names?.addressOf(name, index),
      sixDigits,
    }),
  });
  return parts.length === 0
    ? withBytes(of, span, depth, said)
    : [
        () => rowOf(of, span, depth, said()),
        ...parts.flatMap((inner) =>
          withBytes(of, inner, depth + 1, () => ({ meaning: words.groupFieldMeaning(inner.name, values) })),
        ),
      ];
}

/** A line, and the lines of its bytes if it has several and they are unfolded. */
function withBytes(of: Folding, span: Span, depth: number, said: () => Said): LazyExplanationRow[] {
  const { reading, bytes, words } = of;
  const each = inDigits(reading, span) ? 2 : 1;
  const many = (span.to - span.from) / each;
  if (many < 2 || !Number.isInteger(many)) return [() => rowOf(of, span, depth, said())];
  return unfolding(of, span, depth, said, () =>
    Array.from({ length: many }, (_, index) => () => {
      const at = span.from + index * each;
      const value = numberAt(bytes, at, at + each, each);
      const meaning = words.byteMeaning({ span, index, value, many });
      return rowOf(of, new Span(span.name, span.kind, at, at + each), depth + 1, { meaning });
    }),
  );
}

/** A line whose parts follow it if it is unfolded. */
function unfolding(
  of: Folding,
  span: Span,
  depth: number,
  said: () => Said,
  parts: () => LazyExplanationRow[],
): LazyExplanationRow[] {
  const open = of.unfolded(keyOf(span, depth));
  return [() => rowOf(of, span, depth, said(), open), ...(open ? parts() : [])];
}

const keyOf = ({ from, to }: Span, depth: number) => `${from}-${to}-${depth}`;

/** Whether the bytes of a field are carried as two digits each. */
const inDigits = ({ transport }: Reading, { kind }: Span) =>
  transport === 'ascii' && kind !== 'envelope' && kind !== 'rest';

/** The number that bytes make, the high one first; in digits, two characters a byte. */
function numberAt(bytes: Uint8Array, from: number, to: number, each: number): number {
  const slice = bytes.subarray(from, to);
  return each === 2
    ? Number.parseInt(String.fromCharCode(...slice), 16)
    : slice.reduce((number, byte) => 256 * number + byte, 0);
}

/** Bytes whose number is shown: no field has a longer one. */
const NUMBER = 2;

function rowOf(of: Explained, span: Span, depth: number, said: Said, unfolded?: boolean): ExplanationRow {
  const { reading, bytes, words, names } = of;
  const { kind, from, to } = span;
  const { label = '', name = '', meaning, section, problems = [] } = said;
  const slice = bytes.subarray(from, to);
  const long = slice.length > WHOLE;
  const each = inDigits(reading, span) ? 2 : 1;
  const size = slice.length / each;
  const isNumber = size === 1 || (size <= NUMBER && (each === 2 || reading.transport !== 'ascii'));
  const value = isNumber ? numberAt(bytes, from, to, each) : Number.NaN;
  const sentence = (problem: Problem) => [words.problem(problem), names?.departure(problem)].filter(Boolean).join(' ');
  return {
    key: keyOf(span, depth),
    kind,
    from,
    to,
    offset: to - from === 1 ? String(from) : `${from}–${to - 1}`,
    hex: long ? `${formatBytes(slice.subarray(0, 4))} … ${toHex(slice.subarray(-1))}` : formatBytes(slice),
    decimal: Number.isNaN(value) ? '' : kind === 'checksum' && each === 1 ? slice.join(' ') : String(value),
    bits: size === 1 && !Number.isNaN(value) ? formatBinary(value, 8) : '',
    characters:
      reading.transport === 'ascii' ? characters(long ? slice.subarray(0, WHOLE) : slice) + (long ? '…' : '') : '',
    label,
    name,
    meaning,
    section: section === undefined ? '' : words.section(section),
    depth,
    unfolded,
    severity: worst(problems),
    problems: problems.map(sentence).join('\n'),
  };
}
