import { signal } from '@preact/signals';
import { Sheet } from '../../kit/sheet.tsx';
import { Tabs } from '../../kit/tabs.tsx';
import { useCommand } from '../../parts/commands.ts';
import { useWords } from '../../parts/words.ts';
import './drawer.css';
import { ExampleList } from './example-list.tsx';
import { savedCount } from './saved-frames.ts';
import { SavedPanel } from './saved-panel.tsx';

/** Which of the two lists was open last. */
const chosen = signal<'examples' | 'saved'>('examples');

/** Frames to begin with: those that manuals print, and those saved here. It stays open while somebody goes through them. */
export function Drawer({ onClose }: { readonly onClose: () => void }) {
  const { drawer } = useWords('input');
  useCommand('close', onClose);
  return (
    <Sheet title={drawer.title} close={drawer.close} onClose={onClose} onKey={goThroughRows}>
      <Tabs
        label={drawer.title}
        chosen={chosen.value}
        onChoose={(id) => {
          chosen.value = id;
        }}
        tabs={[
          { id: 'examples', name: drawer.examples, panel: () => <ExampleList /> },
          { id: 'saved', name: drawer.saved(savedCount.value), panel: () => <SavedPanel /> },
        ]}
      />
    </Sheet>
  );
}

const ROW = '[data-row]';

/** Arrows, Home and End go from frame to frame of the list in sight. */
function goThroughRows(event: KeyboardEvent & { readonly currentTarget: HTMLElement }): void {
  const { key, target, currentTarget } = event;
  if (!(target instanceof Element) || target.matches('input')) return;
  const rows = [...currentTarget.querySelectorAll(`[role="tabpanel"]:not([hidden]) ${ROW}`)];
  const from = rows.findIndex((row) => row.closest('li')?.contains(target));
  const to = rows[placeFor(key, from, rows.length)];
  if (!(to instanceof HTMLElement)) return;
  event.preventDefault();
  to.focus();
}

/** The place that a key leads to from a place in a list; −1 for keys that lead nowhere. */
function placeFor(key: string, from: number, count: number): number {
  if (key === 'ArrowDown') return from + 1;
  if (key === 'ArrowUp') return from < 0 ? -1 : Math.max(0, from - 1);
  // The tabs have these keys too.
  if (from < 0) return -1;
  return key === 'Home' ? 0 : key === 'End' ? count - 1 : -1;
}
