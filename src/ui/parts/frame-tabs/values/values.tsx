import { runsOf } from '../../../../workbench/index.ts';
import type { TabProps } from '../../current-frame.ts';
import { useWords } from '../../words.ts';
import { MaskPanel } from './mask-panel.tsx';
import { ValuesPanel } from './values-panel.tsx';

/** What the registers of a frame hold, and what its masks do. */
export function ValuesTab({ of }: TabProps) {
  const words = useWords('values');
  const { value: current } = of;
  const { frame } = current;
  const hasRegisters = frame !== undefined && runsOf(frame.reading, frame.bytes).length > 0;
  const { andMask, orMask } = frame?.reading.fields ?? {};
  const hasMasks = typeof andMask === 'number' && typeof orMask === 'number';
  return (
    <>
      {hasRegisters && <ValuesPanel {...current} />}
      {hasMasks && <MaskPanel {...current} />}
      {!hasRegisters && !hasMasks && <p class="said">{words.noValues}</p>}
    </>
  );
}
