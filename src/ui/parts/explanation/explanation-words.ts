import { useMemo } from 'preact/hooks';
import type { ExplanationWords } from '../../../workbench/index.ts';
import { useWords, useWordsIfNeeded } from '../words.ts';

/** The words of the explanation; those of problems are fetched if the frame has some, and say nothing until then. */
export function useExplanationWords(hasProblems: boolean): ExplanationWords {
  const [page, tools] = [useWords('page'), useWords('tools')];
  const complaints = useWordsIfNeeded('complaints', hasProblems);
  return useMemo(
    () => ({ ...tools, labels: page.labels, section: page.section, problem: complaints?.problem ?? (() => '') }),
    [page, tools, complaints],
  );
}
