import type { View } from '../parts/view.ts';

export const busView: View = {
  id: 'bus',
  part: { words: [], load: () => import('./bus-view.tsx').then(({ load }) => load()) },
};
