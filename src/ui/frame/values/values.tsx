import { computed } from '@preact/signals';
import { runsOf } from '../../../workbench/index.ts';
import { part, Slot } from '../../parts/slot.tsx';
import { evaluation, folds } from '../../parts/store.ts';
import { FramePanel } from '../frame-panel.tsx';

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
    {hasRegisters.value && <FramePanel name="values" fold={folds.values} part={values} />}
    {hasMasks.value && <Slot part={mask} with={{}} />}
  </>
);
