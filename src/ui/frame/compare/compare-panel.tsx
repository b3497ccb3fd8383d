import './compare.css';
import type { CompareProps } from '../../../workbench/index.ts';
import { FoldPanel } from '../../kit/fold.tsx';
import { words } from '../../parts/page-words.ts';
import { Slot } from '../../parts/slot.tsx';
import { comparing } from './sent.ts';

const load = () => import('./comparison.tsx').then((comparison) => comparison.load());

/** The current frame beside what a device sent: what compares them comes when it is first opened. */
export const ComparePanel = ({ draft, frame }: CompareProps) => (
  <FoldPanel
    class="compare"
    title={words.page.compare}
    open={comparing.value}
    onToggle={(open) => {
      comparing.value = open;
    }}
  >
    {() => <Slot part={load} with={{ draft, frame }} />}
  </FoldPanel>
);
