import { computed, type ReadonlySignal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import type { Draft, Evaluation } from '../../workbench/index.ts';
import { useNaming } from './device/naming.ts';
import { draft, evaluation } from './store.ts';

/** Whether there is a frame. */
export const hasFrame = computed(() => evaluation.value.frame !== undefined);

/** The draft, and the frame it comes to. */
export interface CurrentFrame {
  readonly draft: Draft;
  readonly frame: Evaluation['frame'];
}

/** What a tab is given: the frame that it is about, which changes only while the tab is open. */
export interface TabProps {
  readonly of: ReadonlySignal<CurrentFrame>;
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
