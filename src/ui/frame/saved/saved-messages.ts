import type { Imported, Naming } from '../../../store/index.ts';
import type { WordsOf } from '../../../words/index.ts';
import type { Refusal } from '../../../workbench/index.ts';

/** Why nothing was changed. */
export function refusalText(words: WordsOf<'saved'>, refusal: Refusal, name: string): string {
  switch (refusal) {
    case 'refused':
      return words.refused;
    case 'full':
      return words.full;
    case 'unreadable':
      return words.unreadableKept;
    case 'gone':
      return words.gone(name);
  }
}

/** What was done under a name; if that was taken, that both frames are kept. */
export const namingText = (words: WordsOf<'saved'>, { wanted, got }: Naming, done: (name: string) => string): string =>
  wanted === got ? done(got) : words.nameTaken(wanted, got);

export const importLines = (words: WordsOf<'saved'>, { added, already }: Imported): readonly string[] => [
  words.imported(added.length),
  ...(already > 0 ? [words.already(already)] : []),
  ...added.filter(({ wanted, got }) => wanted !== got).map((naming) => namingText(words, naming, String)),
];
