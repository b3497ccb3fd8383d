import type { Subject } from '../../words/index.ts';
import { page } from '../parts/store.ts';
import type { View } from '../parts/view.ts';
import { FrameView } from './frame-view.tsx';

/** The view that the page begins with: it comes with the page, and with a faulty frame what is said of faults. */
export const frameView: View = {
  id: 'frame',
  part: {
    get words(): readonly Subject[] {
      return isFaulty() ? ['tools', 'input', 'complaints'] : ['tools', 'input'];
    },
    async load() {
      if (isFaulty()) await import('../parts/strip/cause.tsx');
      return FrameView;
    },
  },
};

function isFaulty(): boolean {
  const { errors, frame } = page.evaluation.peek();
  return errors.size > 0 || (frame?.reading.problems.length ?? 0) > 0;
}
