import { languages } from '../../../../src/words/index.ts';
import type { ExplanationWords } from '../../../../src/workbench/frame/explanation.ts';

/** The English words of the explanation. */
export async function explanationWords(): Promise<ExplanationWords> {
  const { page, tools, complaints } = languages.en;
  const [{ labels, section }, all, { problem }] = await Promise.all([page(), tools(), complaints()]);
  return { ...all, labels, section, problem };
}
