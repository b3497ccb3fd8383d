import { formatBytes } from '../../notation/index.ts';
import { checkedBytes, type InputKind, type InputReading, inputKinds } from '../../workbench/index.ts';
import { FileButton } from '../kit/file-button.tsx';
import { Segments } from '../kit/segments.tsx';
import { evaluation } from '../parts/store.ts';
import { checksumWords as words } from './checksum-words.ts';
import type { Digest, Source } from './digest.ts';
import { FileProgress } from './file-progress.tsx';

interface InputProps {
  readonly source: Source;
  /** What is typed, also while a file takes its place. */
  readonly text: string;
  readonly kind: InputKind;
  readonly digest: Digest;
  readonly onText: (text: string) => void;
  readonly onKind: (kind: InputKind) => void;
  readonly onFile: (file: File | undefined) => void;
  readonly onCancel: () => void;
  readonly onAgain: () => void;
  readonly onLeave: () => void;
}

/** The id of the field. */
export const INPUT = 'checksum-input';

/** Where bytes are typed or a file is chosen, and what they were read as. */
export function InputPanel(props: InputProps) {
  const { source, kind, digest, onText, onKind, onFile } = props;
  const frame = checkedBytes(evaluation.value);
  const take = (bytes: Uint8Array) => () => {
    onFile(undefined);
    onKind('bytes');
    onText(formatBytes(bytes));
  };
  return (
    <section class="panel checksum-input" aria-labelledby={`${INPUT}-title`}>
      <h2 id={`${INPUT}-title`}>{words.input}</h2>
      {source.kind === 'file' ? (
        <p class="chosen-file">
          <b>{source.file.name}</b> {words.size(source.file.size)}{' '}
          <button type="button" onClick={() => onFile(undefined)}>
            {words.closeFile}
          </button>
        </p>
      ) : (
        <>
          <Segments
            label={words.kind}
            options={inputKinds.map((value) => ({ value, name: words.kinds[value], hint: words.kindHints[value] }))}
            value={kind}
            onChoose={onKind}
          />
          <Typed {...props} />
        </>
      )}
      <FileProgress digest={digest} onCancel={props.onCancel} onAgain={props.onAgain} />
      <div class="read-actions">
        <FileButton label={words.openFile} onFile={onFile} />
        {frame && (
          <>
            <button type="button" onClick={take(frame.body)}>
              {words.body}
            </button>
            <button type="button" onClick={take(frame.whole)}>
              {words.whole}
            </button>
          </>
        )}
      </div>
    </section>
  );
}

function Typed({ text, kind, digest, onText, onLeave }: InputProps) {
  const reading = digest.kind === 'done' ? digest.reading : undefined;
  const problems = reading?.problems ?? [];
  return (
    <div class="control" data-invalid={problems.length > 0 ? '' : undefined}>
      <label for={INPUT}>{words.labels[kind]}</label>
      <textarea
        id={INPUT}
        class="mono"
        rows={Math.min(10, Math.max(2, Math.ceil(text.length / 60)))}
        autocomplete="off"
        spellcheck={false}
        autocapitalize="off"
        aria-describedby={`${INPUT}-said`}
        aria-invalid={problems.length > 0}
        value={text}
        onInput={({ currentTarget }) => onText(currentTarget.value)}
        onFocusOut={onLeave}
      />
      <p class="said" id={`${INPUT}-said`} aria-live="polite">
        {text === '' || reading === undefined ? (
          words.hints[kind]
        ) : (
          <>
            {words.count(reading.bytes.length)}. {reading.notation && words.readAs(reading.notation)}
          </>
        )}
        {problems.map((problem) => (
          <span key={`${problem.start} ${problem.code}`} class="error problem">
            <span class="mono">{text.slice(problem.start, problem.end)}</span> {problemText(problem)}
          </span>
        ))}
      </p>
    </div>
  );
}

/** Each code has the sentence of its own problem. */
const problemText = (problem: InputReading['problems'][number]) =>
  (words.problems[problem.code] as (one: typeof problem) => string)(problem);
