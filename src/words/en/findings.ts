import type { Finding, FindingCode } from '../../diagnosis/index.ts';
import type { FindingWords, WordsFor } from './finding-words.ts';
import { checksum } from './findings-checksum.ts';
import { meaning } from './findings-meaning.ts';
import { shape } from './findings-shape.ts';

const table: WordsFor<FindingCode> = { ...checksum, ...shape, ...meaning };

/** What a finding says in English. */
export function findings(found: Finding): FindingWords {
  // The table has for each code the words that take its finding.
  const say = table[found.code] as (one: Finding) => FindingWords;
  return say(found);
}
