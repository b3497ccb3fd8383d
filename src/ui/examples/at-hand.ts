import type { Draft } from '../../workbench/index.ts';
import { type Example, evaluate, exampleSources } from '../../workbench/index.ts';
import { draft, evaluation, step } from '../state.ts';

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

/** The chosen example whose frame is at hand, also after Back and Forward, and its source. */
export function exampleAtHand() {
  const { transport, kind } = draft.value;
  const bytes = evaluation.value.frame?.bytes.join();
  for (const source of exampleSources) {
    for (const example of source.examples) {
      if (!chosen.has(example) || example.draft.transport !== transport || example.draft.kind !== kind) continue;
      if (evaluate(example.draft).frame?.bytes.join() === bytes) return { source, example };
    }
  }
  return undefined;
}
