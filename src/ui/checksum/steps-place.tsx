import type { CatalogueCrc } from '../../modbus/index.ts';
import { loadSteps } from '../checksum-steps/load.ts';
import { Slot } from '../slot.tsx';
import { Folded } from './folded.tsx';
import { checksumWords as words } from './language.ts';

/** What the step view is given: the bytes, and the algorithm that goes over them. */
export interface StepsProps {
  readonly bytes: Uint8Array;
  readonly algorithm: CatalogueCrc;
}

/** Where the step view stands: folded, and loaded when it is first opened. */
export function StepsPlace(props: StepsProps) {
  return (
    <Folded name="checksum-steps" title={words.steps} hint={words.stepsHint}>
      {() => <Slot load={loadSteps} with={props} />}
    </Folded>
  );
}
