import { computed } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import type { TabProps } from '../current-frame.ts';
import { useNaming } from '../device/naming.ts';
import { Explanation } from '../explanation/explanation.tsx';
import { useSteady } from '../steady.ts';

/** Every byte of the frame, with what the chosen device calls what is in it. */
export function BytesTab({ of }: TabProps) {
  const naming = useNaming();
  const explained = useMemo(
    () =>
      computed(() => {
        const { frame } = of.value;
        return frame && { ...frame, names: naming?.(frame.reading) };
      }),
    [of, naming],
  );
  const hasFrame = useSteady(() => of.value.frame !== undefined, [of]).value;
  return hasFrame && <Explanation of={explained} />;
}
