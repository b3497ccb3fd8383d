import { useId, useState } from 'preact/hooks';
import type { TraceView } from '../../../store/index.ts';
import { completions, type FilterMistake } from '../../../workbench/index.ts';
import { CompletedInput } from '../../kit/completed-input.tsx';
import { useWords } from '../words.ts';

/** What a word lacks that is still being typed: it is not wrong yet. */
const UNFINISHED: ReadonlySet<FilterMistake['code']> = new Set(['value-missing', 'quote-open', 'nothing-excluded']);

/** What the list shows: a text that is completed while it is typed, with its mistakes at their words and in sentences below it. */
export function TraceFilter({ of }: { readonly of: TraceView<File> }) {
  const words = useWords('trace');
  const id = useId();
  const [caret, setCaret] = useState<number>();
  const { value: read } = of.read;
  const mistakes = read.kind === 'mistakes' ? read.mistakes : [];
  const said = mistakes.filter(({ code, to }) => !(UNFINISHED.has(code) && caret === to));
  const { value: known } = of.occurring.known;
  return (
    <div class="trace-filter">
      <div class="in-row">
        <label for={id}>{words.filter}</label>
        <CompletedInput
          id={id}
          text={of.filter.value}
          placeholder={words.filterHint}
          offered={words.completions}
          complete={(text, at) =>
            completions(text, at, known, words.filterNames).map((one) => ({
              ...one,
              hint: words.completion(one),
              goesOn: one.of.kind === 'term',
            }))
          }
          wrong={said}
          describedBy={`${id}-said`}
          onText={(text) => of.setFilter(text, 'edit')}
          onCaret={(at) => {
            setCaret(at);
            if (at !== undefined) of.occurring.want();
          }}
        />
      </div>
      <div id={`${id}-said`} aria-live="polite">
        {said.map((mistake) => (
          <p key={mistake.from} class="error">
            {words.mistake(mistake)}
          </p>
        ))}
        {mistakes.length > 0 && <p class="said">{words.keptFilter(of.applied.value)}</p>}
      </div>
    </div>
  );
}
