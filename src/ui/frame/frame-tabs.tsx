import { signal } from '@preact/signals';
import { useRef } from 'preact/hooks';
import { useSignalWhenSeen } from '../kit/signal-when-seen.ts';
import { Tabs } from '../kit/tabs.tsx';
import { type CurrentFrame, currentFrame, hasFrame, useExplained } from '../parts/current-frame.ts';
import { Explanation } from '../parts/explanation/explanation.tsx';
import { type Part, part, Slot } from '../parts/slot.tsx';
import { useWords } from '../parts/words.ts';
import { Reply } from './tools/reply-panel.tsx';
import { Values } from './values/values.tsx';

type TabId = 'bytes' | 'values' | 'reply' | 'wire' | 'compare';

/** The tab that is open. */
const open = signal<TabId>('bytes');

const wire = part(
  ['wire'],
  () => import('./wire/wire-view.tsx'),
  ({ WireView }) => WireView,
);
const comparison = part(
  ['compare'],
  () => import('./compare/comparison.tsx'),
  ({ ComparisonView }) => ComparisonView,
);

/** What can be said of the current frame, one thing at a time. */
export function FrameTabs() {
  const { tabs: words } = useWords('page').page;
  const panels = {
    bytes: () => <EveryByte />,
    values: () => <Values />,
    reply: () => <Reply />,
    wire: () => <OfFrame part={wire} />,
    compare: () => <OfFrame part={comparison} />,
  } satisfies Record<TabId, unknown>;
  return (
    <section class="panel">
      <Tabs
        label={words.label}
        tabs={(Object.keys(panels) as TabId[]).map((id) => ({ id, name: words.names[id], panel: panels[id] }))}
        chosen={open.value}
        onChoose={(id) => {
          open.value = id;
        }}
      />
    </section>
  );
}

function EveryByte() {
  const of = useExplained();
  return hasFrame.value && <Explanation of={of} />;
}

/** A part about the current frame. Out of sight, it follows typing at a pause. */
function OfFrame({ part: of }: { readonly part: Part<CurrentFrame> }) {
  const root = useRef<HTMLDivElement>(null);
  const shown = useSignalWhenSeen(currentFrame, root);
  return (
    <div ref={root}>
      <Slot part={of} with={shown.value} reserve={120} />
    </div>
  );
}
