import type { ComponentType } from 'preact';
import { loadToolWords } from '../../../words/index.ts';
import type { ExplanationProps } from './explanation.tsx';

/** The explanation of a frame, with its sentences. */
export async function loadExplanation(): Promise<ComponentType<Omit<ExplanationProps, 'words'>>> {
  const [{ Explanation }, words] = await Promise.all([import('./explanation.tsx'), loadToolWords()]);
  return (props) => <Explanation {...props} words={words} />;
}
