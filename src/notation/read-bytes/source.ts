import { type DumpLine, dumpLines } from './dumps.ts';
import { plainText } from './plain-text.ts';
import { type Section, sectionsOf } from './sections.ts';
import type { ChunkLabel } from './types.ts';

/** A text, and what all readings of it by numbers share, worked out once when it is asked for. */
export class Source {
  readonly plain: string;
  #sections: readonly Section[] | undefined;
  #dump: ReadonlyMap<Section, DumpLine> | undefined;

  constructor(text: string) {
    this.plain = plainText(text);
  }

  /** The sections that are taken for bytes. */
  get sections(): readonly Section[] {
    this.#sections ??= withBracketDirections(
      withoutLineNumbers(this.plain, withoutRepeats(this.plain, certain(this.plain, sectionsOf(this.plain)))),
    );
    return this.#sections;
  }

  get dump(): ReadonlyMap<Section, DumpLine> {
    this.#dump ??= dumpLines(this.plain, this.sections);
    return this.#dump;
  }
}

/** How much of a line before its numbers is compared, in characters. */
const LEAD = 16;

/**
 * Where some lines are surely bytes, those that only may be are not; bytes one by one in a log are told by direction. Where
 * no line looks like bytes, they still are if all lines are alike.
 */
function certain(plain: string, sections: readonly Section[]): readonly Section[] {
  const isSure = sections.some(({ certainty }) => certainty === 3);
  const chosen = sections.filter(
    ({ certainty, label, tokens }) =>
      certainty === 3 || (certainty === 2 && (!isSure || (label.direction !== undefined && tokens[0]?.base === 16))),
  );
  if (chosen.length > 0 || sections.length < 2) return chosen;
  const leads = new Set(
    sections.map(({ tokens: [first] }) => {
      const start = first?.start ?? 0;
      const lead = plain.slice(Math.max(0, start - LEAD), start);
      return lead.slice(lead.lastIndexOf('\n') + 1).replace(/\d+/g, '0');
    }),
  );
  return leads.size === 1 ? sections : [];
}

/** Leaves out what a log says again when it begins to work on a frame that it has just received. */
function withoutRepeats(plain: string, sections: readonly Section[]): readonly Section[] {
  const textOf = ({ tokens }: Section) => plain.slice(tokens[0]?.start, tokens.at(-1)?.end);
  return sections.filter((section, index) => {
    const before = sections[index - 1];
    const isNews = section.alone || section.label.direction !== undefined || before?.label.direction === undefined;
    return isNews || textOf(section) !== textOf(before);
  });
}

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
  const isNarrow = sections.some(({ first }) => first !== undefined && (first.to - first.from) % 2 !== 0);
  if (sections.length < 2 || !isNarrow || !sections.every(isCounted)) return sections;
  if (sections.some(({ tokens }) => tokens.slice(1).some(({ from, to }) => to - from !== 2))) return sections;
  return sections.map((section) => ({ ...section, tokens: section.tokens.slice(1) }));
}

const BRACKET_DIRECTION = { '[': { direction: 'tx' }, '<': { direction: 'rx' }, '': {} } as const satisfies Record<
  string,
  ChunkLabel
>;

/** libmodbus prints what it sends in square brackets and what it receives in angle brackets. */
function withBracketDirections(sections: readonly Section[]): readonly Section[] {
  const brackets = new Set(sections.map(({ tokens }) => tokens[0]?.bracket));
  if (!brackets.has('[') || !brackets.has('<')) return sections;
  return sections.map((section) => ({
    ...section,
    label: { ...BRACKET_DIRECTION[section.tokens[0]?.bracket ?? ''], ...section.label },
  }));
}
