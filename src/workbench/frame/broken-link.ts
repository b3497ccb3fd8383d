import type { LinkReading } from './link.ts';

/** Unknown parts that are named, and how much of each. */
const MOST_NAMED = 8;
const LONGEST_NAMED = 100;
/** How much of a link that could not be read in full is shown. */
const SHOWN = 400;

/** What there is to say of a link that could not be read in full, however long it is. */
export interface BrokenLink {
  /** Its beginning. */
  readonly text: string;
  /** Its length in characters. */
  readonly length: number;
  /** The first parts that mean nothing here, each cut to a length that can be shown. */
  readonly unknown: readonly string[];
  /** How many more there are. */
  readonly more: number;
  readonly newer: number | undefined;
  readonly tooLong: boolean;
}

export function brokenLink(hash: string, { unknown, newer, tooLong = false }: LinkReading): BrokenLink {
  return {
    text: cut(hash, SHOWN),
    length: hash.length,
    unknown: unknown.slice(0, MOST_NAMED).map((part) => cut(part, LONGEST_NAMED)),
    more: Math.max(0, unknown.length - MOST_NAMED),
    newer,
    tooLong,
  };
}

const cut = (text: string, most: number): string => (text.length > most ? `${text.slice(0, most)}…` : text);
