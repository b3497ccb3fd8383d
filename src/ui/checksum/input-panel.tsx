import type { ChecksumView } from '../../store/index.ts';
import { inputKinds } from '../../workbench/index.ts';
import { Field } from '../kit/field.tsx';
import { FileButton } from '../kit/file-button.tsx';
import { Segments } from '../kit/segments.tsx';
import { TextArea } from '../kit/text-input.tsx';
import type { ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import { FileProgress } from './file-progress.tsx';

/** The id of the field. */
export const INPUT = 'checksum-input';

/** Where bytes are typed or a file is chosen, and what they were read as. */
export function InputPanel({ view }: ViewProps<ChecksumView>) {
  const words = useWords('checksum');
  const { file, kind } = view.shown.value;
  const frame = view.frame.value;
  return (
    <section class="panel checksum-input" aria-labelledby={`${INPUT}-title`}>
      <h2 id={`${INPUT}-title`}>{words.input}</h2>
      {file ? (
        <p class="chosen-file">
          <b>{file.name}</b> {words.size(file.size)}{' '}
          <button type="button" onClick={() => view.change({ file: undefined })}>
            {words.closeFile}
          </button>
        </p>
      ) : (
        <>
          <Segments
            label={words.kind}
            options={inputKinds.map((value) => ({ value, name: words.kinds[value], hint: words.kindHints[value] }))}
            value={kind}
            onChoose={(chosen) => view.change({ kind: chosen })}
          />
          <Typed view={view} />
        </>
      )}
      <FileProgress view={view} />
      <div class="read-actions in-row">
        <FileButton label={words.openFile} onFile={(chosen) => view.change({ file: chosen })} />
        {frame && (
          <>
            <button type="button" onClick={() => view.takeBytes(frame.body)}>
              {words.body}
            </button>
            <button type="button" onClick={() => view.takeBytes(frame.whole)}>
              {words.whole}
            </button>
          </>
        )}
      </div>
    </section>
  );
}

/** Characters of a line, by which the height of the field is guessed. */
const LINE = 60;

function Typed({ view }: ViewProps<ChecksumView>) {
  const words = useWords('checksum');
  const { text, kind } = view.shown.value;
  const digest = view.digest.value;
  const reading = digest.kind === 'done' ? digest.reading : undefined;
  const problems = reading?.problems ?? [];
  const problemText = (problem: (typeof problems)[number]) =>
    // Each code has the sentence of its own problem.
    (words.problems[problem.code] as (one: typeof problem) => string)(problem);
  const hint =
    text === '' || reading === undefined ? (
      words.hints[kind]
    ) : (
      <>
        {words.count(reading.bytes.length)}. {reading.notation && words.readAs(reading.notation)}
      </>
    );
  const more = problems.map((problem) => (
    <span key={`${problem.start} ${problem.code}`} class="error problem">
      <span class="mono">{text.slice(problem.start, problem.end)}</span> {problemText(problem)}
    </span>
  ));
  return (
    <Field id={INPUT} label={words.labels[kind]} hint={hint} more={more}>
      <TextArea
        id={INPUT}
        text={text}
        wrong={problems.length > 0}
        line={LINE}
        onText={(typed) => view.change({ text: typed })}
      />
    </Field>
  );
}
