import type { ComponentChildren } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import type { TraceView } from '../../../store/index.ts';
import type { LogTab } from '../../../workbench/index.ts';
import { bringTo } from '../../kit/bring-to.ts';
import { Tabs } from '../../kit/tabs.tsx';
import { part, Slot } from '../../parts/slot.tsx';
import { useWords } from '../../parts/words.ts';
import './trace-tabs.css';

const parts = {
  timeline: part(
    ['trace'],
    () => import('./timeline-tab.tsx'),
    ({ TimelineTab }) => TimelineTab,
  ),
  statistics: part(
    ['trace'],
    () => import('./statistics-tab.tsx'),
    ({ StatisticsTab }) => StatisticsTab,
  ),
  values: part(
    ['trace'],
    () => import('./values-tab.tsx'),
    ({ ValuesTab }) => ValuesTab,
  ),
} as const;
const counted = ['timeline', 'statistics', 'values'] as const;

/** Milliseconds after which what has grown is counted again. */
const AGAIN = 1000;

interface TraceTabsProps {
  readonly of: TraceView<File>;
  readonly chosen: LogTab;
  readonly onChoose: (tab: LogTab) => void;
  /** The list. */
  readonly children: ComponentChildren;
}

/** The list of a trace, and what can be counted of it. */
export function TraceTabs({ of, chosen, onChoose, children }: TraceTabsProps) {
  const { tabs: words } = useWords('trace');
  const { tabs } = of;
  useEffect(() => {
    if (chosen === 'rows') return tabs.want(undefined);
    const timer = setInterval(tabs.refresh, AGAIN);
    return () => clearInterval(timer);
  }, [tabs, chosen]);
  const root = useRef<HTMLElement>(null);
  const [brought, bring] = useState(0);
  // What was pressed is hidden then.
  useEffect(() => {
    if (brought > 0) bringTo(root.current?.querySelector<HTMLElement>('[role="listbox"]') ?? null);
  }, [brought]);
  const toRows = () => {
    onChoose('rows');
    bring(brought + 1);
  };
  const given = { of, toRows };
  return (
    <section class="trace-tabs" ref={root}>
      <Tabs
        label={words.label}
        tabs={[
          { id: 'rows', name: words.names.rows, panel: () => children },
          ...counted.map((id) => ({
            id,
            name: words.names[id],
            panel: () => <Slot part={parts[id]} with={{ ...given, open: id === chosen }} />,
          })),
        ]}
        chosen={chosen}
        onChoose={onChoose}
      />
    </section>
  );
}
