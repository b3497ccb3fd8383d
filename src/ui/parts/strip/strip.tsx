import type { ReadonlySignal } from '@preact/signals';
import type { ComponentChildren } from 'preact';
import { useMemo, useState } from 'preact/hooks';
import { type StaleReason, verdictOf, worst } from '../../../workbench/index.ts';
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
  readonly edit?: ByteEdit | undefined;
  /** Why the frame is not the current one; it is dimmed then. */
  readonly stale?: StaleReason | undefined;
  /** Whether an address of the frame may be two things, and nobody has said which. */
  readonly isOpen?: boolean;
  /** Why the frame is as it is, beside the verdict. */
  readonly cause?: ComponentChildren;
  readonly actions?: ComponentChildren;
  /** What stands beside the actions. */
  readonly children?: ComponentChildren;
}

/** A frame in short: the verdict, its fields with their bytes and meaning, and what can be done with it. */
export function Strip({ of, label, edit, stale, isOpen = false, cause, actions, children }: StripProps) {
  const { strip: words } = useWords('page');
  const strip = useMemo(() => new StripState(of, edit), [of, edit]);
  const [unfolded, setUnfolded] = useState(false);
  return (
    <section class="strip" aria-label={label} data-stale={stale && ''} data-unfolded={unfolded ? '' : undefined}>
      <div class="strip-head">
        <VerdictLine of={of} stale={stale} isOpen={isOpen} />
        <button type="button" class="unfold" aria-expanded={unfolded} onClick={() => setUnfolded(!unfolded)}>
          <span class="unseen">{words.keepInSight}</span>
          <span aria-hidden="true">{unfolded ? '▴' : '▾'}</span>
        </button>
      </div>
      <div class="strip-body">
        <div class="strip-cause" aria-live="polite">
          {cause}
        </div>
        <div class="strip-main">
          {children}
          <StripFields strip={strip} />
          <div class="strip-actions">{actions}</div>
        </div>
      </div>
    </section>
  );
}

/** The verdict in a word, and what the frame is; or why it is not the current one. It is read out when it changes. */
function VerdictLine({ of, stale, isOpen }: Pick<StripProps, 'of' | 'stale'> & { readonly isOpen: boolean }) {
  const { strip: words, labels } = useWords('page');
  const verdict = useSteady(() => {
    const { value } = of;
    if (value === undefined) return undefined;
    const { reading, bytes } = value;
    const found = reading.outcome.kind === 'whole' ? worst(reading.problems) : 'error';
    return {
      severity: isOpen && found !== 'error' ? 'warning' : found,
      word: words.verdict(verdictOf(reading, isOpen), reading),
      size: words.kindAndSize(reading, bytes.length),
    };
  }, [of, words, isOpen]).value;
  const why = stale && words.stale[stale.code](stale.code === 'field' ? (labels[stale.path] ?? stale.path) : '');
  const { severity, word, size } = verdict ?? { word: words.noFrame, size: '' };
  return (
    <p class="strip-verdict" data-severity={severity === 'note' ? undefined : severity} aria-live="polite">
      <strong>{stale && verdict ? words.before : word}</strong> <span class="size">{why ?? size}</span>
    </p>
  );
}
