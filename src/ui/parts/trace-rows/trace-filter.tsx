import type { TraceView } from '../../../store/index.ts';
import { useWords } from '../words.ts';

/** What the list shows: a text whose mistakes are said below it. */
export function TraceFilter({ of }: { readonly of: TraceView<File> }) {
  const words = useWords('trace');
  const { value: read } = of.read;
  const mistakes = read.kind === 'mistakes' ? read.mistakes : [];
  return (
    <div class="trace-filter">
      <label class="in-row">
        {words.filter}
        <input
          type="search"
          class="mono"
          value={of.filter.value}
          placeholder={words.filterHint}
          autocomplete="off"
          spellcheck={false}
          aria-invalid={mistakes.length > 0}
          onInput={({ currentTarget }) => of.setFilter(currentTarget.value, 'edit')}
        />
      </label>
      {mistakes.map((mistake) => (
        <p key={mistake.from} class="error">
          {words.mistake(mistake)}
        </p>
      ))}
    </div>
  );
}
