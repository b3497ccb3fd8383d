import type { ComponentType } from 'preact';
import type { CatalogueCrc } from '../../modbus/index.ts';
import { Slot } from '../slot.tsx';
import { Folded } from './folded.tsx';
import { checksumWords as words } from './language.ts';

/** What the step view is given: the bytes, and the algorithm that goes over them. */
export interface StepsProps {
  readonly bytes: Uint8Array;
  readonly algorithm: CatalogueCrc;
}

/** STEP VIEW: what brings it, in place of `undefined`. */
const loadSteps: (() => Promise<ComponentType<StepsProps>>) | undefined = undefined;

/** Where the step view stands: folded, and loaded when it is first opened. */
export function StepsPlace(props: StepsProps) {
  if (loadSteps === undefined) return null;
  const load = loadSteps;
  return (
    <Folded name="checksum-steps" title={words.steps} hint={words.stepsHint}>
      {() => <Slot load={load} with={props} />}
    </Folded>
  );
}
