import type { View } from '../parts/view.ts';
import { FrameView } from './frame-view.tsx';

/** The view that the page begins with: it comes with the page. */
export const frameView: View = {
  id: 'frame',
  part: { words: ['complaints', 'tools', 'input'], load: async () => FrameView },
};
