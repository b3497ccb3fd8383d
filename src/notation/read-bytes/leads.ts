import { isFrame } from './evidence.ts';
import type { Token } from './items.ts';
import { bytesIn, readDecimal, readHex } from './numbers.ts';
import type { Section } from './sections.ts';

/** The most numbers that are looked at before a frame. */
const MOST = 6;
/** Fewest numbers of a ruler: `00 01 02 03 04 05 06 07`. */
const RULER = 8;
/** Fewest numbers of a frame. */
const FRAME = 4;

/**
 * Leaves out the numbers that stand before the bytes of their line and are not bytes: how many follow in a table, or what is
 * said of the frame (`Slave 17, FC 03: 11 03 …`). A line whose frame holds only without them shows it, for all lines of its
 * form; and the numbers over the columns of a dump are left out.
 */
export function withoutLeads(
  plain: string,
  sections: readonly Section[],
  formOf: (section: Section) => string,
): readonly Section[] {
  const rows = sections.length > 1 ? sections.filter((section) => !isRuler(plain, section)) : sections;
  const kept = rows.length > 0 ? rows : sections;
  const leads = new Map<string, number>();
  for (const section of kept) {
    const lead = mayHaveLead(plain, section) ? leadIn(plain, section) : 0;
    if (lead > 0) leads.set(formOf(section), lead);
  }
  if (leads.size === 0) return kept;
  return kept.map((section) => {
    const lead = leads.get(formOf(section)) ?? 0;
    if (lead === 0 || !(isCount(plain, section.tokens) || isCut(section, lead))) return section;
    return { ...section, tokens: section.tokens.slice(lead) };
  });
}

const mayHaveLead = (plain: string, { tokens, runs }: Section): boolean =>
  tokens.length > FRAME && tokens[0]?.base === 0 && (runs.length > 1 || isCount(plain, tokens));

/** How many numbers stand before a frame and do not belong to it; 0 if there are no such numbers. */
function leadIn(plain: string, section: Section): number {
  const { tokens } = section;
  const holds = (some: readonly Token[]) => [readHex, readDecimal].some((read) => isFrame(bytesIn(plain, some, read)));
  const cuts = isCount(plain, tokens) ? [1] : [];
  for (let at = 1; at <= MOST && at + FRAME <= tokens.length; at++) if (isCut(section, at)) cuts.push(at);
  const cut = cuts.find((at) => holds(tokens.slice(at)));
  return cut === undefined || holds(tokens) ? 0 : cut;
}

/** Whether a run of numbers begins with the number at a place. */
const isCut = ({ tokens, runs }: Section, at: number): boolean => runs.some((run) => run.tokens[0] === tokens[at]);

/** Whether a row begins with how many numbers follow. */
const isCount = (plain: string, [first, ...rest]: readonly Token[]): boolean =>
  first !== undefined && first.base === 0 && Number(plain.slice(first.from, first.to)) === rest.length;

/** Whether numbers count up from one that ends in 0, as above the columns of a dump and of a table. */
function isRuler(plain: string, { tokens, label }: Section): boolean {
  if (tokens.length < RULER || label.direction !== undefined) return false;
  const first = Number.parseInt(plain.slice(tokens[0]?.from, tokens[0]?.to), 16);
  return (
    first % RULER === 0 &&
    tokens.every(
      ({ from, to }, index) => to - from <= 2 && Number.parseInt(plain.slice(from, to), 16) === first + index,
    )
  );
}
