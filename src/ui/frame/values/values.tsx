import type { Draft, Evaluation } from '../../../workbench/index.ts';
import { runsOf } from '../../../workbench/index.ts';
import { MaskPanel } from './mask-panel.tsx';
import { ValuesPanel } from './values-panel.tsx';

interface ValuesProps {
  readonly draft: Draft;
  readonly frame: Evaluation['frame'];
}

/** What the registers of the current frame hold, and what its masks do, where it has any. */
export function Values({ draft, frame }: ValuesProps) {
  if (frame === undefined) return null;
  const runs = runsOf(frame.reading, frame.bytes);
  const { andMask, orMask } = frame.reading.fields;
  return (
    <>
      {runs.length > 0 && <ValuesPanel runs={runs} table={frame.reading.description?.table} />}
      {typeof andMask === 'number' && typeof orMask === 'number' && (
        <MaskPanel draft={draft} reading={frame.reading} masks={{ andMask, orMask }} />
      )}
    </>
  );
}
