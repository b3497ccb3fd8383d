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

/** Kinds of fields whose two bytes make one number. */
export const PAIRS: ReadonlySet<FieldKind> = new Set([
  'address',
  'quantity',
  'number',
  'choice',
  'flag',
  'envelope',
  'count',
  'checksum',
]);

/** Longest run of bytes printed whole in a line; a longer field has its items' lines below. */
const WHOLE = 8;

/** The lines that explain a frame, in the order of its bytes. */
export function explain(reading: Reading, bytes: Uint8Array): Row[] {
  return reading.spans.flatMap((span) => {
    const { transport } = reading;
    const problems = reading.problems.filter(
      (problem) => problem.span.from === span.from || inside(problem.span, span),
    );
    const parts = partsOf(reading, bytes, span);
    const row = rowOf(span, bytes, transport, {
      label: words.labels[span.name] ?? span.name,
      meaning: words.meaning({ reading, bytes, span }),
      section: sectionOf(reading, span.name),
      problems,
      item: false,
    });
    return [row, ...byteRows(span, bytes, transport), ...parts.map((part) => itemRow(reading, bytes, span, part))];
  });
}

/** A line for each byte of a number of two, whose order matters. */
function byteRows(span: Span, bytes: Uint8Array, transport: Reading['transport']): Row[] {
  if (transport === 'ascii' || span.to - span.from !== 2 || !PAIRS.has(span.kind)) return [];
  return [0, 1].map((index) => {
    const at = span.from + index;
    return rowOf(new Span(span.name, span.kind, at, at + 1), bytes, transport, {
      label: '',
      meaning: words.byteMeaning(span.kind, index, bytes[at] as number),
      section: undefined,
      problems: [],
      item: true,
    });
  });
}

const inside = (inner: Span, outer: Span) => outer.from <= inner.from && inner.to <= outer.to && inner.to > inner.from;

function itemRow(reading: Reading, bytes: Uint8Array, span: Span, part: Part): Row {
  const kind = fieldByName(reading, span.name)?.kind ?? span.kind;
  const { index, values } = part;
  return rowOf(part.span, bytes, reading.transport, {
    label: '',
    meaning: words.itemMeaning({ reading, name: span.name, kind, index, values }),
    section: undefined,
    problems: [],
    item: true,
  });
}

interface RowParts {
  readonly label: string;
  readonly meaning: string;
  readonly section: Section | undefined;
  readonly problems: readonly Problem[];
  readonly item: boolean;
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
    bits: slice.length > 2 ? '' : formatBinary(value, 8 * slice.length),
    characters: transport === 'ascii' ? characters(long ? slice.subarray(0, WHOLE) : slice) + (long ? '…' : '') : '',
    label: parts.label,
    meaning: parts.meaning,
    section: parts.section === undefined ? '' : words.section(parts.section),
    item: parts.item,
    severity: worst(parts.problems),
    problems: parts.problems.map(problemText).join('\n'),
  };
}

/** The worst severity of some problems. */
export function worst(problems: readonly Problem[]): Severity | undefined {
  return (['error', 'warning', 'note'] as const).find((severity) =>
    problems.some((problem) => problem.severity === severity),
  );
}

/** Characters as printed; CR and LF by their names. */
export const characters = (bytes: Uint8Array): string => Array.from(bytes, character).join('');

export function character(byte: number): string {
  if (byte === 0x0d) return 'CR';
  if (byte === 0x0a) return 'LF';
  return byte > 0x20 && byte < 0x7f ? String.fromCharCode(byte) : '·';
}
