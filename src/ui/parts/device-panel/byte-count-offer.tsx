import { useComputed } from '@preact/signals';
import { ownByteCount } from '../../../devices/index.ts';
import { withByteCount } from '../../../workbench/index.ts';
import { allDevices } from '../device/chosen.ts';
import { draft, evaluation, step } from '../store.ts';
import { useWords } from '../words.ts';

/** Offers the byte count that the chosen device wants of the current frame, if the frame has another. */
export function ByteCountOffer() {
  const words = useWords('devices');
  const wanted = useComputed(byteCountWanted).value;
  if (wanted === undefined) return null;
  return (
    <p>
      <button type="button" onClick={() => step(withByteCount(draft.value, wanted))}>
        {words.useByteCount(wanted)}
      </button>
    </p>
  );
}

function byteCountWanted(): number | undefined {
  const profile = allDevices.chosen.value;
  const reading = evaluation.value.frame?.reading;
  const wanted = profile && reading && ownByteCount(profile, reading);
  return wanted === reading?.derived['byteCount'] ? undefined : wanted;
}
