import { computed, type ReadonlySignal } from '@preact/signals';
import { useMemo, useRef } from 'preact/hooks';
import { FoldPanel } from '../kit/fold.tsx';
import { useSignalWhenSeen } from '../kit/signal-when-seen.ts';
import { type Part, Slot } from '../parts/slot.tsx';
import { useWords } from '../parts/words.ts';
import { type CurrentFrame, currentFrame } from './current-frame.ts';

/** What a panel shows is at least so high, in pixels. */
const HEIGHT = 120;

interface PanelProps {
  readonly name: 'values' | 'wire' | 'compare';
  /** Whether the panel is unfolded. */
  readonly fold: { value: boolean };
  readonly part: Part<CurrentFrame>;
}

/** A folded panel about the current frame. Folded, it works nothing out; out of sight, it follows typing at a pause. */
export function FramePanel({ name, fold, part }: PanelProps) {
  const root = useRef<HTMLDetailsElement>(null);
  // What somebody opens is wanted at once.
  const byHand = useRef(false);
  const { title, intro } = useWords('page').page.panels[name];
  const current = useMemo(() => computed(() => (fold.value ? currentFrame.value : undefined)), [fold]);
  const shown = useSignalWhenSeen(current, root);
  return (
    <FoldPanel
      root={root}
      class={name}
      title={title}
      hint={intro}
      open={fold.value}
      onToggle={(open) => {
        byHand.current = true;
        fold.value = open;
      }}
    >
      {() => <PanelBody part={part} shown={shown} reserve={byHand.current ? undefined : HEIGHT} />}
    </FoldPanel>
  );
}

interface BodyProps extends Pick<PanelProps, 'part'> {
  readonly shown: ReadonlySignal<CurrentFrame | undefined>;
  readonly reserve: number | undefined;
}

const PanelBody = ({ part, shown, reserve }: BodyProps) =>
  shown.value && <Slot part={part} with={shown.value} {...(reserve !== undefined && { reserve })} />;
