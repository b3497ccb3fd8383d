import { part } from '../parts/slot.tsx';
import type { View } from '../parts/view.ts';

export const busView: View = {
  id: 'bus',
  part: part(
    ['bus'],
    () => import('./bus-view.tsx'),
    ({ BusView }) => BusView,
  ),
};

/** How the line stands, for the header: the view has come before there is one. */
export const busStatus = part(
  ['bus'],
  () => import('./bus-view.tsx'),
  ({ BusStatus }) => BusStatus,
);
