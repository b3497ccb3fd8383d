import type { View } from '../parts/view.ts';

export const timingView: View = {
  id: 'timing',
  part: { words: [], load: () => import('./timing-view.tsx').then(({ load }) => load()) },
};
