import { part } from '../parts/slot.tsx';
import type { View } from '../parts/view.ts';

export const logView: View = {
  id: 'log',
  part: part(
    ['trace', 'tools'],
    () => import('./log-view.tsx'),
    ({ LogView }) => LogView,
  ),
};
