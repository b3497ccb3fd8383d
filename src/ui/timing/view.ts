import { part } from '../parts/slot.tsx';
import type { View } from '../parts/view.ts';

export const timingView: View = {
  id: 'timing',
  part: part(
    ['timing', 'complaints'],
    () => import('./timing-view.tsx'),
    ({ TimingPanels }) => TimingPanels,
  ),
};
