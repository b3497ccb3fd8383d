import type { Section } from './sections.ts';

/** How many sections back a program may say a frame again. */
const BACK = 6;
/** Fewest digits that are said again in part: of a shorter piece nothing tells. */
const PART = 2;

/** The digits of a section, by which it is compared. */
function digitsOf(plain: string, { tokens }: Section): string {
  let digits = '';
  for (const { from, to } of tokens) digits += to - from === 1 ? `0${plain.slice(from, to)}` : plain.slice(from, to);
  return digits.toLowerCase();
}

/**
 * Leaves out what a log says again: a frame that a program begins to work on, whole or without its unit and checksum, and the
 * shorter states of a buffer that is printed again each time something was added.
 */
export function withoutRepeats(
  plain: string,
  sections: readonly Section[],
  drop: (section: Section) => void,
): readonly Section[] {
  if (sections.every(({ hint, isComment }) => hint === undefined && !isComment)) return sections;
  const kept: Section[] = [];
  const said: string[] = [];
  for (const section of sections) {
    const digits = section.hint === undefined && !section.isComment ? undefined : digitsOf(plain, section);
    if (digits !== undefined && isAgain(section, digits, kept, said)) {
      drop(section);
      continue;
    }
    // A log may say what is done with a frame before it says that it came.
    const last = kept.at(-1);
    if (last?.hint === 'again' && isOneSide(section) && last.label.direction === undefined) {
      const own = digits ?? digitsOf(plain, section);
      const before = said.at(-1) ?? '';
      const isPart = before.length > PART && before.length < own.length && own.includes(before);
      if (isPart || (before === own && section.label.direction === 'rx')) {
        drop(last);
        kept.pop();
        said.pop();
      }
    }
    if (section.hint === 'total' && digits !== undefined) {
      const count = partsOf(digits, kept, said, section.label.direction);
      if (count > 0) {
        const label = { ...section.label, ...kept[kept.length - count]?.label };
        for (const part of kept.splice(-count)) drop(part);
        said.splice(-count);
        kept.push({ ...section, label });
        said.push(digits);
        continue;
      }
    }
    kept.push(section);
    said.push(digits ?? digitsOf(plain, section));
  }
  return kept;
}

const isOneSide = ({ label }: Section): boolean => label.direction === 'rx' || label.direction === 'tx';

/** Whether two directions are said, and they differ. */
const areApart = (one: Section['label']['direction'], other: Section['label']['direction']): boolean =>
  one !== undefined && other !== undefined && one !== other;

/** Whether a section says again what one of the last has said, in whole or, behind a word that says so, in part. */
function isAgain(section: Section, digits: string, kept: readonly Section[], said: readonly string[]): boolean {
  for (let at = kept.length - 1; at >= Math.max(0, kept.length - BACK); at--) {
    const before = said[at] as string;
    // What is sent back is no repetition of what was sent.
    if (areApart(section.label.direction, kept[at]?.label.direction)) continue;
    if (before === digits && (section.hint !== undefined || kept[at]?.line === section.line)) return true;
    if (section.hint !== 'again' || section.label.direction !== undefined || digits.length < PART) continue;
    if (before.includes(digits)) return true;
  }
  return false;
}

/** Of how many of the last sections a buffer is the sum; an earlier state of the buffer stands for all before it. */
function partsOf(
  digits: string,
  kept: readonly Section[],
  said: readonly string[],
  direction: Section['label']['direction'],
): number {
  let rest = digits;
  for (let at = kept.length - 1; at >= Math.max(0, kept.length - BACK); at--) {
    const before = said[at] as string;
    if (areApart(direction, kept[at]?.label.direction)) return 0;
    if (before === '' || !rest.endsWith(before))
      return (kept[at]?.hint === 'total' || at === kept.length - 1) && before !== '' && digits.startsWith(before)
        ? kept.length - at
        : 0;
    rest = rest.slice(0, -before.length);
    if (rest === '') return kept.length - at;
  }
  return 0;
}
