import { part } from '../parts/slot.tsx';
import type { View } from '../parts/view.ts';

export const devicesView: View = {
  id: 'devices',
  part: part(
    ['devices', 'library', 'bus'],
    () => import('./devices-view.tsx'),
    ({ DevicesView }) => DevicesView,
  ),
};
