import { useState } from 'preact/hooks';
import { type FoundFunction, findFunctions } from '../../../workbench/index.ts';
import { draft, step } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';

/** Finds a function by typing; Enter takes the first. */
export function Finder() {
  const words = useWords('tools');
  const { codeRanges } = useWords('page').page;
  const [query, setQuery] = useState('');
  const found = findFunctions(query);
  const choose = ({ texts }: FoundFunction) => {
    setQuery('');
    step({ ...draft.value, texts: { ...draft.value.texts, ...texts } });
  };
  return (
    <search>
      <input
        type="search"
        aria-label={words.find}
        placeholder={words.findHint}
        autocomplete="off"
        spellcheck={false}
        value={query}
        onInput={({ currentTarget }) => setQuery(currentTarget.value)}
        onKeyDown={(event) => {
          const [first] = found;
          if (event.key !== 'Enter' || first === undefined) return;
          event.preventDefault();
          choose(first);
        }}
      />
      {query.trim() !== '' && (
        <ul class="found" aria-label={words.found(found.length)}>
          {found.map((each) => (
            <li key={each.name}>
              <button type="button" onClick={() => choose(each)}>
                {each.name}
                {each.range && `: ${codeRanges[each.range]}`}
              </button>
            </li>
          ))}
          {found.length === 0 && <li>{words.found(0)}</li>}
        </ul>
      )}
    </search>
  );
}
