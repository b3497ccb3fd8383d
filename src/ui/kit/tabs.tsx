import type { ComponentChildren } from 'preact';
import { useId, useLayoutEffect, useRef } from 'preact/hooks';
import './tabs.css';

interface Tab<T extends string> {
  readonly id: T;
  readonly name: ComponentChildren;
  /** What the panel holds, made when it is first opened. */
  readonly panel: () => ComponentChildren;
}

interface TabsProps<T extends string> {
  /** What the tabs are of. */
  readonly label: string;
  readonly tabs: readonly Tab<T>[];
  readonly chosen: T;
  readonly onChoose: (id: T) => void;
}

/** The tab a key leads to; `undefined` for keys that lead nowhere. */
function tabForKey(key: string, from: number, count: number): number | undefined {
  if (key === 'Home') return 0;
  if (key === 'End') return count - 1;
  const by = key === 'ArrowRight' ? 1 : key === 'ArrowLeft' ? -1 : undefined;
  return by && (from + by + count) % count;
}

/** Panels of which one is open. A panel is drawn when it is first opened, and keeps what was typed in it. */
export function Tabs<T extends string>({ label, tabs, chosen, onChoose }: TabsProps<T>) {
  const opened = useRef(new Set<T>()).current;
  opened.add(chosen);
  const id = useId();
  const list = useRef<HTMLDivElement>(null);
  const isFirst = tabs[0]?.id === chosen;
  const open = useRef<HTMLButtonElement>(null);
  const moved = useRef(false);
  // A row that scrolls inside itself shows the tab that is open.
  useLayoutEffect(() => {
    if (isFirst && !moved.current) return;
    moved.current = true;
    const row = list.current;
    const tab = open.current;
    if (row && tab) row.scrollLeft = tab.offsetLeft - (row.clientWidth - tab.offsetWidth) / 2;
  }, [chosen]);
  const go = (event: KeyboardEvent & { readonly currentTarget: HTMLElement }) => {
    const at = tabForKey(
      event.key,
      Math.max(
        0,
        tabs.findIndex((tab) => tab.id === chosen),
      ),
      tabs.length,
    );
    const tab = at !== undefined && tabs[at];
    if (!tab) return;
    event.preventDefault();
    onChoose(tab.id);
    event.currentTarget.querySelectorAll<HTMLElement>('[role="tab"]')[at]?.focus();
  };
  return (
    <div class="tabs">
      <div role="tablist" aria-label={label} ref={list} onKeyDown={go}>
        {tabs.map((tab) => (
          <button
            key={tab.id}
            ref={tab.id === chosen ? open : null}
            type="button"
            role="tab"
            id={`${id}-${tab.id}`}
            aria-selected={tab.id === chosen}
            aria-controls={`${id}-${tab.id}-panel`}
            tabIndex={tab.id === chosen ? 0 : -1}
            onClick={() => onChoose(tab.id)}
          >
            {tab.name}
          </button>
        ))}
      </div>
      {tabs.map((tab) => (
        <div
          key={tab.id}
          role="tabpanel"
          id={`${id}-${tab.id}-panel`}
          aria-labelledby={`${id}-${tab.id}`}
          hidden={tab.id !== chosen}
        >
          {opened.has(tab.id) && tab.panel()}
        </div>
      ))}
    </div>
  );
}
