import { useState } from 'preact/hooks';
import { chips } from '../../../workbench/index.ts';
import { part, Slot } from '../../parts/slot.tsx';
import { page } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';

const drawer = part(
  ['examples', 'saved', 'stripMore'],
  () => import('../drawer/drawer.tsx'),
  ({ Drawer }) => Drawer,
);

/** Texts to try, and the way to all examples and saved frames. */
export function Chips() {
  const words = useWords('input');
  const [open, setOpen] = useState(false);
  return (
    <div class="chips in-row">
      <span class="soft">{words.tryThis}</span>
      {chips.map((chip) => (
        <button
          key={chip.id}
          type="button"
          onClick={() => {
            if ('log' in chip) return page.open('log', { log: chip.log });
            page.takeInput(chip.text, 'step');
            if (chip.tab) page.openTab(chip.tab);
          }}
        >
          {words.chips[chip.id]}
        </button>
      ))}
      <button type="button" aria-expanded={open} onClick={() => setOpen(!open)}>
        {words.drawer.open}
      </button>
      {open && <Slot part={drawer} with={{ onClose: () => setOpen(false) }} />}
    </div>
  );
}
