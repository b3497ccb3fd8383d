import { formatBytes } from '../../notation/index.ts';
import { Segments } from '../frame/segments.tsx';
import { evaluation } from '../state.ts';
import { atHand } from './frame-at-hand.ts';
import { checksumWords as words } from './language.ts';
import { type InputKind, type InputReading, inputKinds } from './read-input.ts';

interface InputProps {
  readonly text: string;
  readonly kind: InputKind;
  readonly reading: InputReading;
  readonly onText: (text: string) => void;
  readonly onKind: (kind: InputKind) => void;
  readonly onLeave: () => void;
}

const ID = 'checksum-input';

/** Where the bytes are typed, and what they were read as. */
export function InputPanel({ text, kind, reading, onText, onKind, onLeave }: InputProps) {
  const frame = atHand(evaluation.value);
  const take = (bytes: Uint8Array) => () => {
    onKind('bytes');
    onText(formatBytes(bytes));
  };
  return (
    <section class="panel checksum-input">
      <h2>{words.input}</h2>
      <Segments
        label={words.kind}
        options={inputKinds.map((value) => ({ value, name: words.kinds[value], hint: words.kindHints[value] }))}
        value={kind}
        onChoose={onKind}
      />
      <div class="control" data-invalid={reading.problems.length > 0 ? '' : undefined}>
        <label for={ID}>{words.kinds[kind]}</label>
        <textarea
          id={ID}
          class="mono"
          rows={Math.min(10, Math.max(2, Math.ceil(text.length / 60)))}
          autocomplete="off"
          spellcheck={false}
          autocapitalize="off"
          aria-describedby={`${ID}-said`}
          value={text}
          onInput={({ currentTarget }) => onText(currentTarget.value)}
          onFocusOut={onLeave}
        />
        <p class="said" id={`${ID}-said`} aria-live="polite">
          {text === '' ? (
            words.hints[kind]
          ) : (
            <>
              {words.count(reading.bytes.length)} {reading.notation && words.readAs(reading.notation)}
            </>
          )}
          {reading.problems.map((problem) => (
            <span key={problem.start} class="error problem">
              {problemText(problem)}
            </span>
          ))}
        </p>
      </div>
      {frame && (
        <p class="at-hand">
          {words.frameAtHand}{' '}
          <button type="button" onClick={take(frame.body)}>
            {words.body}
          </button>{' '}
          <button type="button" onClick={take(frame.whole)}>
            {words.whole}
          </button>
        </p>
      )}
    </section>
  );
}

/** Each code has the sentence of its own problem. */
const problemText = (problem: InputReading['problems'][number]) =>
  (words.problems[problem.code] as (one: typeof problem) => string)(problem);
