import type { ToolWords } from '../../../words/index.ts';
import type { ExplanationWords } from '../../../workbench/index.ts';
import { problemText, words } from '../page-words.ts';

/** The words of the explanation: some come at first, some with the tools. */
export const explanationWords = (tools: ToolWords): ExplanationWords => ({
  ...tools,
  labels: words.labels,
  section: words.section,
  problem: problemText,
});
