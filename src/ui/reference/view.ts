import type { View } from '../parts/view.ts';

export const referenceView: View = {
  id: 'reference',
  part: { words: [], load: () => import('./reference-view.tsx').then(({ load }) => load()) },
};
