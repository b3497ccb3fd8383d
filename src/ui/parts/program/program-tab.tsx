import { useLayoutEffect, useMemo } from 'preact/hooks';
import { programForFrame } from '../../../workbench/index.ts';
import type { TabProps } from '../current-frame.ts';
import { ProgramPanel } from './program-panel.tsx';
import { programs } from './program-store.ts';

/** The program of the frame: of a reply that of its request. */
export function ProgramTab({ of }: TabProps) {
  const { draft, frame } = of.value;
  const wanted = useMemo(() => programForFrame(draft, frame), [draft, frame]);
  useLayoutEffect(programs.open, []);
  return <ProgramPanel wanted={wanted} reading={frame?.reading} />;
}
