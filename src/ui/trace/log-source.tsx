import { FileButton } from '../kit/file-button.tsx';
import { Fold } from '../kit/fold.tsx';
import { useWords } from '../parts/words.ts';
import { BinaryFile } from './binary-file.tsx';
import { log, logAddress } from './log.ts';

/** What is opened, how far it is, and what was wrong with it. */
export function LogSource() {
  const words = useWords('trace');
  const state = log.state.value;
  const waiting = logAddress.waiting.value;
  const missing = log.missing.value;
  return (
    <div class="in-row log-source">
      <FileButton label={words.openFile} onFile={logAddress.open} />
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
        {state.kind === 'empty' && (waiting ? words.notKept(waiting.source) : words.empty)}
        {state.kind === 'open' && words.source(state.name, state.format, log.own.value)}
        {state.kind === 'failed' && <span class="error">{words.failed[state.code]}</span>}
      </span>
      {log.file.value && <BinaryFile key={log.file.value} file={log.file.value} />}
      <LogProblems />
      {(missing !== undefined || logAddress.untaken.value.length > 0) && (
        <ul class="problems edges log-untaken">
          {logAddress.untaken.value.map((part) => (
            <li key={part.name} data-severity="warning">
              {words.untaken(part)}
            </li>
          ))}
          {missing !== undefined && (
            <li data-severity="warning">
              {words.missing(missing, (log.summary.value?.frames ?? 0) + log.pieces.value)}
            </li>
          )}
        </ul>
      )}
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
