import { computed } from '@preact/signals';
import { targetsOf } from '../../../workbench/index.ts';
import { Fold } from '../../kit/fold.tsx';
import { device } from '../../parts/device/naming.ts';
import { part, Slot } from '../../parts/slot.tsx';
import { evaluation } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';

const named = part(
  ['values'],
  () => import('./named-values.tsx'),
  ({ NamedValues }) => NamedValues,
);
const typed = part(
  ['values'],
  () => import('./typed-box.tsx'),
  ({ TypedBox }) => TypedBox,
);

const hasTargets = computed(() => targetsOf(evaluation.value).length > 0);

/** For fields that hold registers: the device's names for what may be written, and typed values that become the registers. */
export function WriteValues() {
  const { writeValues } = useWords('page').page;
  if (!hasTargets.value) return null;
  return (
    <>
      {device.value && <Slot part={named} with={{}} />}
      <Fold class="write-values" summary={writeValues}>
        {() => <Slot part={typed} with={{}} />}
      </Fold>
    </>
  );
}
