import './compare.css';
import type { CompareProps } from '../../../workbench/index.ts';
import { words } from '../../parts/page-words.ts';
import { Slot } from '../../parts/slot.tsx';
import { comparing } from './sent.ts';

const load = () => import('./comparison.tsx').then((comparison) => comparison.load());

/** The current frame beside what a device sent: what compares them comes when it is first opened. */
export const ComparePanel = ({ draft, frame }: CompareProps) => (
  <details
    class="panel compare"
    open={comparing.value}
    onToggle={({ currentTarget }) => {
      comparing.value = currentTarget.open;
    }}
  >
    <summary>
      <h2>{words.page.compare}</h2>
    </summary>
    {comparing.value && <Slot load={load} with={{ draft, frame }} />}
  </details>
);
