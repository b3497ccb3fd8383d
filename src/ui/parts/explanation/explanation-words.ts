import { useMemo } from 'preact/hooks';
import type { ExplanationWords } from '../../../workbench/index.ts';
import { useWords } from '../words.ts';

/** The words of the explanation. */
export function useExplanationWords(): ExplanationWords {
  const [page, tools, complaints] = [useWords('page'), useWords('tools'), useWords('complaints')];
  return useMemo(
    () => ({ ...tools, labels: page.labels, section: page.section, problem: complaints.problem }),
    [page, tools, complaints],
  );
}
