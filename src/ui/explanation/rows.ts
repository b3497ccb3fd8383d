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
} from '../../modbus/index.ts';
import { formatBinary, formatBytes } from '../../notation/index.ts';
import type { ToolWords } from '../../words/index.ts';
import { characters, worst } from '../../workbench/index.ts';
import type { FrameNames } from '../device/naming.ts';
import { problemText, words } from '../language.ts';

/** One line of the explanation: a field, or one item of a list. Made of text only, so that equal lines are known as such. */
export interface Row {
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
export type LazyRow = () => Row;

/** What the lines say: the frame, the words for it, and what a device calls what is in it. */
interface Said {
  readonly reading: Reading;
  readonly bytes: Uint8Array;
  readonly words: ToolWords;
  readonly names?: FrameNames | undefined;
}

/** The lines that explain a frame, in the order of its bytes. */
export const explain = (said: Said): Row[] => linesOf(said).map((line) => line());

/** The lines of `explain`, each still to be made. */
export const linesOf = (said: Said): LazyRow[] =>
  said.reading.spans.flatMap((span) => {
    const parts = partsOf(said.reading, said.bytes, span);
    return [
      () => fieldRow(said, span),
      ...(parts.length > 0 ? parts.flatMap((part) => partRows(said, span, part)) : byteRows(said, span)),
    ];
  });

function fieldRow({ reading, bytes, words: { meaning }, names }: Said, span: Span): Row {
  return rowOf(span, bytes, reading.transport, {
    label: words.labels[span.name] ?? span.name,
    meaning: named(names?.field(span.name), meaning({ reading, bytes, span })),
    section: sectionOf(reading, span.name),
    problems: reading.problems.filter((problem) => problem.span.from === span.from || inside(problem.span, span)),
    item: false,
    sentence: (problem) => [problemText(problem), names?.departure(problem)].filter(Boolean).join(' '),
  });
}

/** What a device calls it stands before what the specification says of it. */
const named = (name: string | undefined, meaning: string) => (name ? `${name} ${meaning}` : meaning);

const inside = (inner: Span, outer: Span) => outer.from <= inner.from && inner.to <= outer.to && inner.to > inner.from;

/** An item of a list; under it the fields of a group, each with its bytes. */
function partRows(said: Said, span: Span, part: Part): LazyRow[] {
  const { reading, words, names } = said;
  const kind = fieldByName(reading, span.name)?.kind ?? span.kind;
  const { index, values, parts } = part;
  return [
    () => {
      const address = names?.addressOf(span.name, index);
      const meaning = words.itemMeaning({ reading, name: span.name, kind, index, values, address });
      return itemRow(said, part.span, named(names?.item(span.name, index), meaning));
    },
    ...(parts.length > 0
      ? parts.flatMap((inner) => [
          () => itemRow(said, inner, words.groupFieldMeaning(inner.name, values)),
          ...byteRows(said, inner),
        ])
      : byteRows(said, part.span)),
  ];
}

/** A line for each byte of what has several. The two digits of a byte in ASCII stand together. */
function byteRows(said: Said, span: Span): LazyRow[] {
  const digits = said.reading.transport === 'ascii' && span.kind !== 'envelope' && span.kind !== 'rest';
  const each = digits ? 2 : 1;
  const many = (span.to - span.from) / each;
  if (many < 2 || !Number.isInteger(many)) return [];
  return Array.from({ length: many }, (_, index) => () => {
    const at = span.from + index * each;
    const value = digits ? digitsAt(said.bytes, at) : (said.bytes[at] as number);
    const meaning = said.words.byteMeaning({ span, index, value, many });
    return itemRow(said, new Span(span.name, span.kind, at, at + each), meaning);
  });
}

const digitsAt = (bytes: Uint8Array, at: number) =>
  Number.parseInt(String.fromCharCode(...bytes.subarray(at, at + 2)), 16);

const itemRow = ({ bytes, reading }: Said, span: Span, meaning: string): Row =>
  rowOf(span, bytes, reading.transport, {
    label: '',
    meaning,
    section: undefined,
    problems: [],
    item: true,
    sentence: problemText,
  });

interface RowParts {
  readonly label: string;
  readonly meaning: string;
  readonly section: Section | undefined;
  readonly problems: readonly Problem[];
  readonly item: boolean;
  readonly sentence: (problem: Problem) => string;
}

function rowOf({ kind, from, to }: Span, bytes: Uint8Array, transport: Reading['transport'], parts: RowParts): Row {
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
