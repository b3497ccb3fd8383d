import type { View } from '../parts/view.ts';

export const checksumView: View = {
  id: 'checksum',
  part: { words: [], load: () => import('./checksum-view.tsx').then(({ load }) => load()) },
};
