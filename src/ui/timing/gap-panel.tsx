import type { TimingView } from '../../store/index.ts';
import { SectionNames } from '../parts/section-names.tsx';
import type { ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import { TimeField } from './entry-field.tsx';

/** What a gap between two characters does to a frame. */
export function GapPanel({ view }: ViewProps<TimingView>) {
  const text = useWords('timing');
  const { mode, line, gap } = view.reading.value;
  return (
    <section class="panel" aria-labelledby="timing-gap">
      <h2 id="timing-gap">{text.gapTitle}</h2>
      <TimeField view={view} name="gap" label={text.gap} />
      {line === undefined || gap === undefined ? (
        <p>{text.correct}</p>
      ) : (
        <p class="result" aria-live="polite" data-effect={gap.effect}>
          <b>{text.effects[gap.effect]}.</b>{' '}
          {mode === 'rtu' ? text.rtuGap(gap.effect, line.silences) : text.asciiGap(gap.effect)}{' '}
          {gap.other && text.otherReading(gap.other.bits, gap.other.effect)}{' '}
          <SectionNames of={mode === 'rtu' ? 'SL 2.5.1.1' : 'SL 2.5.2.1'} />
        </p>
      )}
    </section>
  );
}
