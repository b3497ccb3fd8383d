import { part } from '../parts/slot.tsx';
import type { View } from '../parts/view.ts';

export const checksumView: View = {
  id: 'checksum',
  part: part(
    ['checksum'],
    () => import('./checksum-view.tsx'),
    ({ ChecksumPanels }) => ChecksumPanels,
  ),
};
