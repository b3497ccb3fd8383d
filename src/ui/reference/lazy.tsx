import type { ComponentChild } from 'preact';
import { loadReferenceWords } from '../../words/index.ts';
import { Cell } from '../cell.ts';

/** The Reference view, which comes with its words when it is first opened. */
export const reference = new Cell<ComponentChild>(<main />);

export async function fetchReference(): Promise<void> {
  const [{ openReference }, text] = await Promise.all([import('./reference-view.tsx'), loadReferenceWords()]);
  reference.value = openReference(text);
}
