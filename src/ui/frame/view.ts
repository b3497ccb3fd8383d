import { type Brought, bring } from '../parts/slot.tsx';
import { page } from '../parts/store.ts';
import { cause } from '../parts/strip/current-strip.tsx';
import type { View } from '../parts/view.ts';
import { isOther, otherField } from './field-control.tsx';
import { FrameView } from './frame-view.tsx';

/** The view that the page begins with: it comes with the page. */
export const frameView: View = {
  id: 'frame',
  part: {
    get words() {
      return ['tools', 'input', ...needed().flatMap(({ words }) => words)] as const;
    },
    async load() {
      await Promise.all(needed().map((part) => bring(part)));
      return FrameView;
    },
  },
};

/** What only some frames need. It comes before the first of them is drawn, so that nothing moves. */
function needed(): readonly Brought[] {
  const { errors, frame, controls } = page.evaluation.peek();
  const faulty = errors.size > 0 || (frame?.reading.problems.length ?? 0) > 0;
  const other = controls.some(({ field, derived }) => !derived && isOther(field));
  return [...(faulty ? [cause] : []), ...(other ? [otherField] : [])];
}
