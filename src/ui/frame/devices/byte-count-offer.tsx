import { ownByteCount, type Profile } from '../../../devices/index.ts';
import { withByteCount } from '../../../workbench/index.ts';
import { deviceWords as words } from '../../parts/device/device-words.ts';
import { draft, evaluation } from '../../parts/store.ts';
import { stepTo } from '../current-frame.ts';

/** The byte count that the device wants of the current frame, where the frame has another. */
export function byteCountWanted(profile: Profile | undefined): number | undefined {
  const reading = evaluation.value.frame?.reading;
  const wanted = profile && reading && ownByteCount(profile, reading);
  return wanted === reading?.derived['byteCount'] ? undefined : wanted;
}

/** Offers the byte count that the device wants. */
export const ByteCountOffer = ({ wanted }: { wanted: number | undefined }) =>
  wanted === undefined ? null : (
    <p>
      <button type="button" onClick={() => stepTo(withByteCount(draft.value, wanted))}>
        {words.useByteCount(wanted)}
      </button>
    </p>
  );
