import { en, loadComplaints, loadToolWords } from '../../../../src/words/index.ts';
import type { ExplanationWords } from '../../../../src/workbench/frame/explanation.ts';

/** The English words of the explanation. */
export async function explanationWords(): Promise<ExplanationWords> {
  const [tools, { problems }] = await Promise.all([loadToolWords(), loadComplaints()]);
  return {
    ...tools,
    labels: en.labels,
    section: en.section,
    problem: (problem) => (problems[problem.code] as (of: typeof problem) => string)(problem),
  };
}
