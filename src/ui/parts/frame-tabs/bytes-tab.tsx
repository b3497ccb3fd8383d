import { type TabProps, useExplained } from '../current-frame.ts';
import { Explanation } from '../explanation/explanation.tsx';
import { useSteady } from '../steady.ts';

/** Every byte of the frame, with what the chosen device calls what is in it. */
export function BytesTab({ of }: TabProps) {
  const explained = useExplained(of);
  const hasFrame = useSteady(() => of.value.frame !== undefined, [of]).value;
  return hasFrame && <Explanation of={explained} />;
}
