import { computed } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { runsOf } from '../../../workbench/index.ts';
import { useSignalWhenSeen } from '../../kit/signal-when-seen.ts';
import { currentFrame } from '../../parts/current-frame.ts';
import { part, Slot } from '../../parts/slot.tsx';
import { evaluation } from '../../parts/store.ts';

const values = part(
  ['values'],
  () => import('./values-panel.tsx'),
  ({ ValuesPanel }) => ValuesPanel,
);
const mask = part(
  ['values'],
  () => import('./mask-panel.tsx'),
  ({ MaskPanel }) => MaskPanel,
);

const hasRegisters = computed(() => {
  const { frame } = evaluation.value;
  return frame !== undefined && runsOf(frame.reading, frame.bytes).length > 0;
});

const hasMasks = computed(() => {
  const { andMask, orMask } = evaluation.value.frame?.reading.fields ?? {};
  return typeof andMask === 'number' && typeof orMask === 'number';
});

/** What the registers of the current frame hold, and what its masks do. */
export const Values = () => (
  <>
    {hasRegisters.value && <Registers />}
    {hasMasks.value && <Slot part={mask} with={{}} />}
  </>
);

function Registers() {
  const root = useRef<HTMLDivElement>(null);
  const shown = useSignalWhenSeen(currentFrame, root);
  return (
    <div ref={root}>
      <Slot part={values} with={shown.value} reserve={120} />
    </div>
  );
}
