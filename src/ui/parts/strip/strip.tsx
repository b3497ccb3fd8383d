import type { ReadonlySignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useMemo } from 'preact/hooks';
import { verdictOf, worst } from '../../../workbench/index.ts';
import type { ExplainedFrame } from '../explanation/explanation.tsx';
import { useSteady } from '../steady.ts';
import { useWords } from '../words.ts';
import './strip.css';
import { StripFields } from './strip-fields.tsx';
import { type ByteEdit, StripState } from './strip-state.ts';

interface StripProps {
  /** The frame that is shown, with what a device calls what is in it. */
  readonly of: ReadonlySignal<ExplainedFrame | undefined>;
  readonly label: string;
  /** Changes a byte; without it bytes are only read. */
  readonly edit?: ByteEdit;
  /** Why the frame is so, beside the verdict. */
  readonly cause?: ComponentChildren;
  /** What unfolds below the verdict. */
  readonly more?: ComponentChildren;
  readonly actions?: ComponentChildren;
}

/** A frame in short: the verdict, its fields with their bytes and meaning, and what can be done with it. */
export function Strip({ of, label, edit, cause, more, actions }: StripProps) {
  const strip = useMemo(() => new StripState(of, edit), [of, edit]);
  return (
    <section class="strip" aria-label={label}>
      <div class="strip-head">
        <VerdictLine of={of} cause={cause} />
        {more}
      </div>
      <div class="strip-body">
        <StripFields strip={strip} />
        <div class="strip-actions">{actions}</div>
      </div>
    </section>
  );
}

/** The verdict in a word, why, and what the frame is. It is read out when it changes. */
function VerdictLine({ of, cause }: Pick<StripProps, 'of' | 'cause'>) {
  const { strip: words } = useWords('page');
  const verdict = useSteady(() => {
    const { value } = of;
    if (value === undefined) return undefined;
    const { reading, bytes } = value;
    return {
      severity: reading.outcome.kind === 'whole' ? worst(reading.problems) : 'error',
      word: words.verdict(verdictOf(reading), reading),
      size: words.kindAndSize(reading, bytes.length),
    };
  }, [of, words]).value;
  if (verdict === undefined) return null;
  const { severity, word, size } = verdict;
  return (
    <div class="strip-verdict" data-severity={severity === 'note' ? undefined : severity} aria-live="polite">
      <strong>{word}</strong> {cause} <span class="size">{size}</span>
    </div>
  );
}
