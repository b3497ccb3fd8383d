import { signal } from '@preact/signals';
import type { Draft, Example } from '../../workbench/index.ts';
import { step } from '../parts/store.ts';

/** Makes a draft the current frame, as one step, and shows it. */
export function stepTo(next: Draft): void {
  step(next);
  document.querySelector('main > section')?.scrollIntoView({ block: 'nearest' });
}

/** The examples chosen since the page was loaded. */
export const chosenExamples = signal<ReadonlySet<Example>>(new Set());

export function chooseExample(example: Example): void {
  chosenExamples.value = new Set([...chosenExamples.value, example]);
  stepTo(example.draft);
}
