import { type Draft, type Example, shownExample } from '../../workbench/index.ts';
import { draft, evaluation, step } from '../parts/store.ts';

/** Makes a frame the one at hand, as one step, and shows it. */
export function takeUp(next: Draft): void {
  step(next);
  document.querySelector('main > section')?.scrollIntoView({ block: 'nearest' });
}

/** The examples chosen since the page was loaded. */
const chosen = new Set<Example>();

export function choose(example: Example): void {
  chosen.add(example);
  takeUp(example.draft);
}

/** The chosen example whose frame is shown, also after Back and Forward, and its source. */
export const exampleAtHand = () => shownExample(draft.value, evaluation.value.frame, chosen);
