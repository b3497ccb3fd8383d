import { effect, type ReadonlySignal, useSignal } from '@preact/signals';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { type FrameTab, frameTabs } from '../../../workbench/index.ts';
import { useSignalWhenSeen } from '../../kit/signal-when-seen.ts';
import { Tabs } from '../../kit/tabs.tsx';
import type { CurrentFrame } from '../current-frame.ts';
import { part, Slot } from '../slot.tsx';
import { useSteady } from '../steady.ts';
import { useWords } from '../words.ts';
import { BytesTab } from './bytes-tab.tsx';
import './frame-tabs.css';

const laterTab = part(
  [],
  () => import('./later-tab.tsx'),
  ({ LaterTab }) => LaterTab,
);

interface FrameTabsProps {
  /** The frame; `stale` is there if it is not the current one, but the one before. */
  readonly of: ReadonlySignal<CurrentFrame & { readonly stale?: unknown }>;
  readonly chosen: ReadonlySignal<FrameTab>;
  readonly onChoose: (tab: FrameTab) => void;
}

/** What can be said of a frame, one thing at a time. A tab is loaded when it is first opened, and keeps its state. */
export function FrameTabs({ of, chosen, onChoose }: FrameTabsProps) {
  const { tabs: words } = useWords('page').page;
  const stale = useSteady(() => of.value.stale !== undefined, [of]).value;
  return (
    <section class="panel frame-tabs" data-stale={stale ? '' : undefined}>
      <Tabs
        label={words.label}
        tabs={frameTabs.map((id) => ({
          id,
          name: words.names[id],
          panel: () => <Panel id={id} of={of} chosen={chosen} />,
        }))}
        chosen={chosen.value}
        onChoose={onChoose}
      />
    </section>
  );
}

/** What a tab shows. While another is open nothing of it is drawn; out of sight it follows at a pause. */
function Panel({ id, of, chosen }: Omit<FrameTabsProps, 'onChoose'> & { readonly id: FrameTab }) {
  const root = useRef<HTMLDivElement>(null);
  const open = useSignal(of.peek());
  useLayoutEffect(
    () =>
      effect(() => {
        if (chosen.value === id) open.value = of.value;
      }),
    [of, chosen],
  );
  const seen = useSignalWhenSeen(open, root);
  return (
    <div ref={root}>{id === 'bytes' ? <BytesTab of={seen} /> : <Slot part={laterTab} with={{ id, of: seen }} />}</div>
  );
}
