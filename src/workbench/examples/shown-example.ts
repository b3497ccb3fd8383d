import type { Draft } from '../frame/draft.ts';
import { type Evaluation, evaluate } from '../frame/evaluate.ts';
import { type Example, type ExampleSource, exampleSources } from './examples.ts';

/** The first of some examples whose frame a draft has, of the same transport and kind, with its source. */
export function shownExample(
  { transport, kind }: Draft,
  frame: Evaluation['frame'],
  among: ReadonlySet<Example>,
): { readonly source: ExampleSource; readonly example: Example } | undefined {
  const bytes = frame?.bytes.join();
  for (const source of exampleSources) {
    for (const example of source.examples) {
      if (!among.has(example) || example.draft.transport !== transport || example.draft.kind !== kind) continue;
      if (evaluate(example.draft).frame?.bytes.join() === bytes) return { source, example };
    }
  }
  return undefined;
}
