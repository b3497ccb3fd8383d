import { FileButton } from '../kit/file-button.tsx';
import { Fold } from '../kit/fold.tsx';
import { useWords } from '../parts/words.ts';
import { log } from './log.ts';

/** What is opened, how far it is, and what was wrong with it. */
export function LogSource() {
  const words = useWords('trace');
  const state = log.state.value;
  return (
    <div class="in-row log-source">
      <FileButton label={words.openFile} onFile={log.open} />
      {state.kind === 'opening' && (
        <>
          <progress aria-label={words.opening(state.name)} max={100} value={state.percent} />
          <span aria-live="off">{words.openingDone(state.name, state.percent)}</span>
          <button type="button" onClick={log.cancel}>
            {words.cancel}
          </button>
        </>
      )}
      <span role="status">
        {state.kind === 'empty' && words.empty}
        {state.kind === 'open' && words.source(state.name, state.format)}
        {state.kind === 'failed' && <span class="error">{words.failed[state.code]}</span>}
      </span>
      <LogProblems />
    </div>
  );
}

function LogProblems() {
  const words = useWords('trace');
  const { first, count } = log.problems.value;
  if (count === 0) return null;
  return (
    <Fold class="log-problems" summary={words.problems(count)}>
      {() => (
        <ul class="problems edges">
          {first.map((problem, at) => (
            <li key={at} data-severity="note">
              {words.problem(problem)}
            </li>
          ))}
          {count > first.length && <li data-severity="note">{words.moreProblems(count - first.length)}</li>}
        </ul>
      )}
    </Fold>
  );
}
