import type { Subject } from '../../words/index.ts';
import { firstDraft } from '../../workbench/index.ts';
import { page } from '../parts/store.ts';
import type { View } from '../parts/view.ts';
import { FrameView } from './frame-view.tsx';

/**
 * The view that the page begins with: it comes with the page. What only some frames need comes before it is drawn with the
 * first of them, so that nothing moves.
 */
export const frameView: View = {
  id: 'frame',
  part: {
    get words(): readonly Subject[] {
      return [
        'tools',
        'input',
        ...(isFaulty() ? (['complaints', 'stripMore'] as const) : []),
        ...(isLink() ? (['oneByOne'] as const) : []),
      ];
    },
    async load() {
      await Promise.all([isFaulty() && import('../parts/strip/cause.tsx'), isLink() && import('./other-field.tsx')]);
      return FrameView;
    },
  },
};

function isFaulty(): boolean {
  const { errors, frame } = page.evaluation.peek();
  return errors.size > 0 || (frame?.reading.problems.length ?? 0) > 0;
}

const isLink = () => page.draft.peek() !== firstDraft;
