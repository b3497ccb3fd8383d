import { asciiGapEffect, bitsTime, type SerialMode } from '../../modbus/index.ts';
import type { TimingWords } from '../../words/index.ts';
import {
  gapReading,
  knownOf,
  type SetLine,
  type TimingName,
  type TimingTexts,
  timeEntry,
} from '../../workbench/index.ts';
import { words } from '../parts/page-words.ts';
import { EntryField } from './entry-field.tsx';

interface GapProps {
  readonly texts: TimingTexts;
  readonly line: SetLine | undefined;
  readonly mode: SerialMode;
  readonly text: TimingWords;
  readonly set: (name: TimingName, value: string) => void;
}

/** What a gap between two characters does to a frame. */
export function GapPanel({ texts, line, mode, text, set }: GapProps) {
  const entry = timeEntry(texts.gap, line);
  const gap = knownOf(entry);
  return (
    <section class="panel" aria-labelledby="timing-gap">
      <h2 id="timing-gap">{text.gapTitle}</h2>
      <EntryField
        name="gap"
        label={text.gap}
        text={texts.gap}
        entry={entry}
        hint={gap !== undefined && line ? text.timeHint(gap, gap / bitsTime(line.baud, 1)) : undefined}
        onText={set}
      />
      {line === undefined || gap === undefined ? (
        <p>{text.correct}</p>
      ) : mode === 'rtu' ? (
        <RtuGap gap={gap} line={line} text={text} />
      ) : (
        <p class="result" aria-live="polite" data-effect={asciiGapEffect(gap)}>
          <b>{text.effects[asciiGapEffect(gap)]}.</b> {text.asciiGap(asciiGapEffect(gap))}{' '}
          <span class="section">{words.section('SL 2.5.2.1')}</span>
        </p>
      )}
    </section>
  );
}

function RtuGap({ gap, line, text }: { gap: number; line: SetLine; text: TimingWords }) {
  const { effect, other } = gapReading(gap, line);
  return (
    <p class="result" aria-live="polite" data-effect={effect}>
      <b>{text.effects[effect]}.</b> {text.rtuGap(effect, line.silences)}{' '}
      {other && text.otherReading(other.bits, other.effect)} <span class="section">{words.section('SL 2.5.1.1')}</span>
    </p>
  );
}
