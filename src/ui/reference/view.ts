import { part } from '../parts/slot.tsx';
import type { View } from '../parts/view.ts';

export const referenceView: View = {
  id: 'reference',
  part: part(
    ['reference', 'about'],
    () => import('./reference-view.tsx'),
    ({ ReferenceView }) => ReferenceView,
  ),
};
