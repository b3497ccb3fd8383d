import { computed, signal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import type { Draft, Evaluation, Example } from '../../workbench/index.ts';
import { useNaming } from '../parts/device/naming.ts';
import { draft, evaluation, step } from '../parts/store.ts';

/** Whether there is a frame. */
export const hasFrame = computed(() => evaluation.value.frame !== undefined);

/** The draft, and the frame it comes to. */
export interface CurrentFrame {
  readonly draft: Draft;
  readonly frame: Evaluation['frame'];
}

export const currentFrame = computed((): CurrentFrame => ({ draft: draft.value, frame: evaluation.value.frame }));

/** The current frame as it is explained, with what the chosen device calls what is in it; `undefined` if there is none. */
export function useExplained() {
  const naming = useNaming();
  return useMemo(
    () =>
      computed(() => {
        const { frame } = evaluation.value;
        return frame && { ...frame, names: naming?.(frame.reading) };
      }),
    [naming],
  );
}

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
