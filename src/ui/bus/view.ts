import { part } from '../parts/slot.tsx';
import type { View } from '../parts/view.ts';

export const busView: View = {
  id: 'bus',
  part: part(
    ['bus', 'trace'],
    () => import('./bus-view.tsx'),
    ({ BusView }) => BusView,
  ),
};
