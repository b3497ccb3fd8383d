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
  readonly meaning: (of: { readonly reading: Reading; readonly bytes: Uint8Array; readonly span: Span }) => string;
  /** What an item of a list means; `address` where a device does not count one for each item. */
  readonly itemMeaning: (item: {
    readonly reading: Reading;
    readonly name: string;
    readonly kind: FieldKind;
    readonly index: number;
    readonly values: Values;
    readonly address: number | undefined;
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
  readonly meaning: string;
  readonly section: string;
  /** Whether the line is an item of the field above it. */
  readonly item: boolean;
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
}

/** The lines that explain a frame, in the order of its bytes. */
export const explain = (of: Explained): ExplanationRow[] => linesOf(of).map((line) => line());

/** The lines of `explain`, each still to be made. */
export const linesOf = (of: Explained): LazyExplanationRow[] =>
  of.reading.spans.flatMap((span) => {
    const parts = partsOf(of.reading, of.bytes, span);
    return [
      () => fieldRow(of, span),
      ...(parts.length > 0 ? parts.flatMap((part) => partRows(of, span, part)) : byteRows(of, span)),
    ];
  });

function fieldRow({ reading, bytes, words, names }: Explained, span: Span): ExplanationRow {
  return rowOf(span, bytes, reading.transport, words, {
    label: words.labels[span.name] ?? span.name,
    meaning: named(names?.field(span.name), words.meaning({ reading, bytes, span })),
    section: sectionOf(reading, span.name),
    problems: reading.problems.filter((problem) => problem.span.from === span.from || inside(problem.span, span)),
    item: false,
    sentence: (problem) => [words.problem(problem), names?.departure(problem)].filter(Boolean).join(' '),
  });
}

/** What a device calls it stands before what the specification says of it. */
const named = (name: string | undefined, meaning: string) => (name ? `${name} ${meaning}` : meaning);

const inside = (inner: Span, outer: Span) => outer.from <= inner.from && inner.to <= outer.to && inner.to > inner.from;

/** An item of a list; under it the fields of a group, each with its bytes. */
function partRows(of: Explained, span: Span, part: Part): LazyExplanationRow[] {
  const { reading, words, names } = of;
  const kind = fieldByName(reading, span.name)?.kind ?? span.kind;
  const { index, values, parts } = part;
  return [
    () => {
      const address = names?.addressOf(span.name, index);
      const meaning = words.itemMeaning({ reading, name: span.name, kind, index, values, address });
      return itemRow(of, part.span, named(names?.item(span.name, index), meaning));
    },
    ...(parts.length > 0
      ? parts.flatMap((inner) => [
          () => itemRow(of, inner, words.groupFieldMeaning(inner.name, values)),
          ...byteRows(of, inner),
        ])
      : byteRows(of, part.span)),
  ];
}

/** A line for each byte of what has several. The two digits of a byte in ASCII stand together. */
function byteRows(of: Explained, span: Span): LazyExplanationRow[] {
  const digits = of.reading.transport === 'ascii' && span.kind !== 'envelope' && span.kind !== 'rest';
  const each = digits ? 2 : 1;
  const many = (span.to - span.from) / each;
  if (many < 2 || !Number.isInteger(many)) return [];
  return Array.from({ length: many }, (_, index) => () => {
    const at = span.from + index * each;
    const value = digits ? digitsAt(of.bytes, at) : (of.bytes[at] as number);
    const meaning = of.words.byteMeaning({ span, index, value, many });
    return itemRow(of, new Span(span.name, span.kind, at, at + each), meaning);
  });
}

const digitsAt = (bytes: Uint8Array, at: number) =>
  Number.parseInt(String.fromCharCode(...bytes.subarray(at, at + 2)), 16);

const itemRow = ({ bytes, reading, words }: Explained, span: Span, meaning: string): ExplanationRow =>
  rowOf(span, bytes, reading.transport, words, {
    label: '',
    meaning,
    section: undefined,
    problems: [],
    item: true,
    sentence: words.problem,
  });

interface RowParts {
  readonly label: string;
  readonly meaning: string;
  readonly section: Section | undefined;
  readonly problems: readonly Problem[];
  readonly item: boolean;
  readonly sentence: (problem: Problem) => string;
}

function rowOf(
  { kind, from, to }: Span,
  bytes: Uint8Array,
  transport: Reading['transport'],
  words: ExplanationWords,
  parts: RowParts,
): ExplanationRow {
  const slice = bytes.subarray(from, to);
  const long = slice.length > WHOLE;
  const value = slice.reduce((number, byte) => 256 * number + byte, 0);
  return {
    key: `${from}-${to}-${parts.item}`,
    kind,
    from,
    to,
    offset: to - from === 1 ? String(from) : `${from}–${to - 1}`,
    hex: long ? `${formatBytes(slice.subarray(0, 4))} … ${toHex(slice.subarray(-1))}` : formatBytes(slice),
    decimal: slice.length > 2 ? '' : kind === 'checksum' ? slice.join(' ') : String(value),
    bits: slice.length === 1 ? formatBinary(value, 8) : '',
    characters: transport === 'ascii' ? characters(long ? slice.subarray(0, WHOLE) : slice) + (long ? '…' : '') : '',
    label: parts.label,
    meaning: parts.meaning,
    section: parts.section === undefined ? '' : words.section(parts.section),
    item: parts.item,
    severity: worst(parts.problems),
    problems: parts.problems.map(parts.sentence).join('\n'),
  };
}
