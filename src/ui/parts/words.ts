import { createContext } from 'preact';
import { useContext, useEffect, useState } from 'preact/hooks';
import type { Subject, Vocabulary, WordsOf } from '../../words/index.ts';

/** The sentences of the page's language. */
export const Words = createContext<Vocabulary | undefined>(undefined);

/** All sentences that have come, for what brings more of them. */
export function useVocabulary(): Vocabulary {
  const vocabulary = useContext(Words);
  if (vocabulary === undefined) throw new TypeError('no language around');
  return vocabulary;
}

/** What is said about a subject. The part of the page that a component belongs to names the subject (`part`). */
export const useWords = <S extends Subject>(subject: S): WordsOf<S> => useVocabulary().of(subject);

/** What is said about a subject that is only needed at times: fetched when it is `needed` first, and `undefined` until then. */
export function useWordsIfNeeded<S extends Subject>(subject: S, needed: boolean): WordsOf<S> | undefined {
  const vocabulary = useVocabulary();
  const [, come] = useState(false);
  const waits = needed && !vocabulary.has(subject);
  useEffect(() => {
    // A part that shows these words says if they do not come.
    if (waits)
      vocabulary.load(subject).then(
        () => come(true),
        () => undefined,
      );
  }, [waits]);
  return vocabulary.has(subject) ? vocabulary.of(subject) : undefined;
}
