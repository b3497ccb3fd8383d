import { computed, type ReadonlySignal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { type Draft, type Evaluation, isSixDigits } from '../../workbench/index.ts';
import { useNaming } from './device/naming.ts';
import { page } from './store.ts';

/** The draft, and the frame it comes to. */
export interface CurrentFrame {
  readonly draft: Draft;
  readonly frame: Evaluation['frame'];
}

/** What a tab is given: the frame that it is about, which changes only while the tab is open. */
export interface TabProps {
  readonly of: ReadonlySignal<CurrentFrame>;
}

/** The frame that is shown: the current one, or the last there was. */
export const currentFrame: ReadonlySignal<CurrentFrame> = page.shown;

/** Whether there is a frame to show. */
export const hasFrame = computed(() => currentFrame.value.frame !== undefined);

/** A frame, the one that is shown unless another is given, as it is explained, with what the chosen device calls what is in it; `undefined` if there is none. */
export function useExplained(of = currentFrame) {
  const naming = useNaming();
  return useMemo(
    () =>
      computed(() => {
        const { frame, draft } = of.value;
        return frame && { ...frame, names: naming?.(frame.reading), sixDigits: isSixDigits(draft) };
      }),
    [of, naming],
  );
}
