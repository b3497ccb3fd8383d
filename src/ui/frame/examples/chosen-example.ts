import { signal } from '@preact/signals';
import type { Example } from '../../../workbench/index.ts';
import { step } from '../../parts/store.ts';

/** The examples chosen since the page was loaded. */
export const chosenExamples = signal<ReadonlySet<Example>>(new Set());

export function chooseExample(example: Example): void {
  chosenExamples.value = new Set([...chosenExamples.value, example]);
  step(example.draft);
}
