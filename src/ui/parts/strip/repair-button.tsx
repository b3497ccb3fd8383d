import { disabledFor } from '../../kit/disabled-for.ts';
import { useSteady } from '../steady.ts';
import { evaluation } from '../store.ts';
import { useWords } from '../words.ts';
import { found } from './found.ts';

/** Makes what was most probably meant the current frame. Its room is kept until it is known. */
export function RepairButton() {
  const words = useWords('stripMore');
  const repaired = found.value?.repair;
  const label =
    repaired === undefined
      ? words.useRepaired
      : repaired.changes === 'checksum'
        ? words.useChecksum(repaired.part)
        : words.useRepaired;
  const use = () => {
    // While a frame is typed, what was found may be of the one before.
    if (repaired && found.peek()?.of === evaluation.peek().frame?.bytes) found.peek()?.use(repaired.bytes);
  };
  const looked = found.value?.of === useSteady(() => evaluation.value.frame?.bytes).value;
  if (looked && repaired === undefined) return null;
  return (
    <button
      type="button"
      class={repaired ? 'first' : 'first waiting'}
      onClick={use}
      {...disabledFor(repaired === undefined ? words.looking : undefined)}
    >
      {label}
    </button>
  );
}
