import { useEffect } from 'preact/hooks';
import type { ChecksumView } from '../../store/index.ts';
import { part, Slot } from '../parts/slot.tsx';
import type { ViewProps } from '../parts/use-view.ts';
import { useVocabulary, useWords } from '../parts/words.ts';
import { Folded } from './remembered-fold.tsx';

const steps = part(
  ['checksumSteps'],
  () => import('./steps/steps-view.tsx'),
  ({ StepsView }) => StepsView,
);

/** Where the step view stands, folded. It is loaded right behind this view, so that opening it costs its drawing alone. */
export function StepsPlace({ view }: ViewProps<ChecksumView>) {
  const words = useWords('checksum');
  const vocabulary = useVocabulary();
  useEffect(() => {
    // What does not come now is asked for again when it is opened.
    Promise.all([steps.load(), vocabulary.load(...steps.words)]).catch(() => undefined);
  }, []);
  const bytes = view.bytes.value;
  const algorithm = view.chosen.value.crc;
  return (
    bytes &&
    algorithm && (
      <Folded name="checksum-steps" title={words.steps} hint={words.stepsHint}>
        {() => <Slot part={steps} with={{ bytes, algorithm }} />}
      </Folded>
    )
  );
}
