import { signal } from '@preact/signals';
import type { Problem } from '../../modbus/index.ts';
import { type Complaints, en, loadComplaints, type Words } from '../../words/index.ts';
import type { InputError } from '../../workbench/index.ts';

/** The language of the page. */
export const words: Words = en;

/**
 * The sentences about what is wrong come right behind the first view, so that the page stands at once; until they are
 * there, codes stand in for them.
 */
export const complaints = signal<Complaints | undefined>(undefined);

export async function fetchComplaints(): Promise<void> {
  complaints.value = await loadComplaints();
}

/** A problem in words, without its section. */
export function problemText(problem: Problem): string {
  return complaints.value?.problem(problem) ?? problem.code;
}

/** What is wrong with an input, in words. */
export const inputErrorText = (error: InputError): string => complaints.value?.inputError(error) ?? error.code;
