import { type AsciiPiece, asciiFramesOf } from './ascii-frames.ts';
import { withAssignments } from './assignments.ts';
import { type DumpLine, dumpLines } from './dumps.ts';
import { isFrame } from './evidence.ts';
import type { Token } from './items.ts';
import { withoutLeads } from './leads.ts';
import { bytesIn, readDecimal, readHex } from './numbers.ts';
import { type Line, linesOf, plainText } from './plain-text.ts';
import { withoutRepeats } from './repeats.ts';
import { type Section, sectionsOf } from './sections.ts';
import { type StringPiece, stringsOf } from './strings.ts';
import { withTables } from './tables.ts';
import type { TextRange } from './types.ts';

/** A text, and what all readings of it by numbers share, worked out once when it is asked for. */
export class Source {
  readonly plain: string;
  readonly lines: readonly Line[];
  /** All numbers, once the sections were asked for, and those that the text says again. */
  numbers: readonly Token[] = [];
  readonly repeated = new Set<Token>();
  /** The addresses of network cards. */
  addresses: readonly TextRange[] = [];
  #sections: readonly Section[] | undefined;
  #dump: ReadonlyMap<Section, DumpLine> | undefined;
  #strings: readonly StringPiece[] | undefined;
  #frames: readonly AsciiPiece[] | undefined;

  readonly #tell: (done: number) => void;

  /** `tell` hears how much of the lines has been read, 0 to 1. */
  constructor(text: string, tell: (done: number) => void = () => undefined) {
    this.#tell = tell;
    this.plain = plainText(text);
    this.lines = linesOf(text, this.plain);
  }

  /** The sections that are taken for bytes. */
  get sections(): readonly Section[] {
    this.#sections ??= this.#choose();
    return this.#sections;
  }

  get dump(): ReadonlyMap<Section, DumpLine> {
    this.#dump ??= dumpLines(this.plain, this.sections);
    return this.#dump;
  }

  get strings(): readonly StringPiece[] {
    this.#strings ??= stringsOf(this.plain, this.lines);
    return this.#strings;
  }

  /** The frames in ASCII. */
  get frames(): readonly AsciiPiece[] {
    this.#frames ??= asciiFramesOf(this.plain, this.lines);
    return this.#frames;
  }

  /** The number of the line at a place of the text. */
  lineAt = (place: number): number => {
    let [low, high] = [0, this.lines.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if ((this.lines[middle]?.start ?? 0) <= place) low = middle;
      else high = middle - 1;
    }
    return low;
  };

  #choose(): readonly Section[] {
    const { sections, numbers, addresses } = sectionsOf(this.plain, this.lines, this.#tell);
    this.numbers = numbers;
    this.addresses = addresses;
    const all = withAssignments(this.plain, this.lines, withTables(this.plain, sections));
    const once = withoutRepeats(this.plain, certain(this.plain, all), ({ tokens }) => {
      for (const token of tokens) this.repeated.add(token);
    });
    const alone = withoutLineNumbers(this.plain, once);
    return withMarks(withoutLeads(this.plain, alone, (section) => leadOf(this.plain, section)));
  }
}

/** How much of a line before its numbers is compared, in characters. */
const LEAD = 24;
/** Digits of an address of 32 bits. */
const POINTER = 8;
/** Fewest numbers of a comment that are bytes. */
const COMMENT = 4;

/** What stands before the numbers of a section, with all digits alike. */
export function leadOf(plain: string, { tokens: [first], line }: Section): string {
  const end = first?.start ?? line.end;
  return plain.slice(Math.max(line.start, end - LEAD), end).replace(/\d+/g, '0');
}

/**
 * Where some lines are surely bytes, those that only may be are not, unless they have the form of one that is; bytes one by
 * one in a log are told by direction. Where no line looks like bytes, they still are if all lines are alike.
 */
function certain(plain: string, sections: readonly Section[]): readonly Section[] {
  const isSure = (section: Section) =>
    (section.certainty === 3 || (section.certainty === 2 && isProved(plain, section))) &&
    (!section.isComment || section.tokens.length >= COMMENT || section.label.direction !== undefined);
  const isTold = isEachTold(sections);
  if (!isTold && sections.every(isSure)) return sections;
  const sure = sections.filter(isSure);
  const leads = new Set(sure.filter(({ alone }) => !alone).map((section) => leadOf(plain, section)));
  const chosen = sections.filter((section) => {
    const { certainty, label, tokens, isComment, alone } = section;
    if (isSure(section)) return !isTold || !isStray(section);
    if (isComment) return false;
    if (!alone && tokens.every(isByte) && leads.has(leadOf(plain, section))) return true;
    return (
      certainty === 2 &&
      (sure.length === 0 || (label.direction !== undefined && tokens[0]?.base === 16 && !isPointer(tokens)))
    );
  });
  if (chosen.length > 0 || sections.length < 2) return chosen;
  const all = new Set(sections.map((section) => leadOf(plain, section)));
  return all.size === 1 ? sections : [];
}

/** Whether numbers, of which nothing but their number says that they are bytes, are a frame. */
const isProved = (plain: string, { tokens }: Section): boolean =>
  tokens.length >= COMMENT && [readDecimal, readHex].some((read) => isFrame(bytesIn(plain, tokens, read)));

/** Whether the text says a direction of all that is written as bytes are. */
const isEachTold = (sections: readonly Section[]): boolean =>
  sections.some(({ label }) => label.direction !== undefined) &&
  sections.every((section) =>
    section.label.direction !== undefined ? section.runs[0]?.style !== 'narrow' : isStray(section),
  );

/** One or two short numbers that are all of their line, as a program lists its values: `1          0`. */
const isStray = ({ alone, tokens, label, runs, continued, line }: Section): boolean =>
  label.direction === undefined &&
  !continued &&
  !line.hasColumn &&
  alone &&
  tokens.length <= 2 &&
  runs[0]?.style === 'narrow';

/** Whether a number is a place in the memory of a controller rather than bytes: `handler 0x400da598`. */
const isPointer = ([first, second]: readonly Token[]): boolean =>
  second === undefined && first !== undefined && first.to - first.from === POINTER;

const isByte = ({ from, to }: Token) => to - from <= 3;

/** Leaves out numbers that count the lines: each one more than that of the line before, and not written as bytes are. */
function withoutLineNumbers(plain: string, sections: readonly Section[]): readonly Section[] {
  const isCounted = (section: Section, index: number) => {
    const { tokens, first } = section;
    if (first === undefined || tokens.length < 2 || tokens[0] !== first || first.base !== 0) return false;
    const digits = plain.slice(first.from, first.to);
    const before = sections[index - 1]?.first;
    const follows = before === undefined || Number(digits) === Number(plain.slice(before.from, before.to)) + 1;
    return follows && /^(?:0|[1-9]\d*)$/.test(digits);
  };
  if (sections.length < 2 || !sections.every(isCounted)) return sections;
  const isNarrow = sections.some(({ first }) => first !== undefined && (first.to - first.from) % 2 !== 0);
  if (!isNarrow || sections.some(({ tokens }) => tokens.slice(1).some(({ from, to }) => to - from !== 2)))
    return sections;
  return sections.map((section) => ({ ...section, tokens: section.tokens.slice(1) }));
}

/** The marks before bytes that are sent, and those before bytes that are received in the same texts. */
const MARKS = [
  ['[', '<', 'tx', 'rx'],
  ['>', '<', 'tx', 'rx'],
  ['->', '<-', 'tx', 'rx'],
  ['»', '«', 'tx', 'rx'],
  ['M', 'S', 'request', 'response'],
  ['Q', 'A', 'request', 'response'],
  ['S', 'R', 'tx', 'rx'],
  ['O', 'I', 'tx', 'rx'],
] as const;

/**
 * libmodbus prints what it sends in square brackets and what it receives in angle brackets; others put an arrow or a letter
 * before it.
 */
function withMarks(sections: readonly Section[]): readonly Section[] {
  const marks = new Set(sections.map(({ mark }) => mark));
  const pair = MARKS.find(([sent, received]) => marks.has(sent) && marks.has(received));
  if (pair === undefined) return sections;
  return sections.map((section) => {
    if (section.label.direction !== undefined || (section.mark !== pair[0] && section.mark !== pair[1])) return section;
    const direction = section.mark === pair[0] ? pair[2] : pair[3];
    return { ...section, label: { ...section.label, direction } };
  });
}
