import type { ComponentChildren } from 'preact';
import { KeptChoice } from '../../../store/index.ts';
import {
  type CopyChoice,
  canCopyAs,
  copyFormats,
  copyText,
  explanationText,
  firstCopyChoice,
  hasChecksum,
  readCopyChoice,
} from '../../../workbench/index.ts';
import { Select } from '../../kit/choice.tsx';
import { Copying } from '../../kit/copy-button.tsx';
import { useCommand, useKeyOf } from '../commands.ts';
import { useExplained } from '../current-frame.ts';
import { useExplanationWords } from '../explanation/explanation-words.ts';
import { useSteady } from '../steady.ts';
import { evaluation, storage } from '../store.ts';
import { useWords } from '../words.ts';

/** The format copied last. */
const copyChoice = new KeptChoice(storage, 'copy', firstCopyChoice, readCopyChoice);

const choose = (change: Partial<CopyChoice>): void => {
  copyChoice.value = { ...copyChoice.value, ...change };
};

/** Longest text shown on the button itself. */
const SHOWN = 24;

/** The current frame as it is copied; empty if there is none. */
function copiedText(): string {
  const { frame } = evaluation.value;
  if (frame === undefined) return '';
  const { reading, bytes } = frame;
  const { value: choice } = copyChoice;
  return copyText(reading, bytes, choice) ?? copyText(reading, bytes, { ...choice, format: 'spaced' }) ?? '';
}

/** Copies the frame in the format used last, or in any other, and its explanation. */
export function CopyBar() {
  const words = useWords('tools');
  const { columns } = useWords('page').page;
  const explained = useExplained();
  const explanationWords = useExplanationWords();
  const text = useSteady(copiedText).value;
  const explanation = (as: 'markdown' | 'table') => () =>
    explained.value ? explanationText({ ...explained.value, words: explanationWords }, columns, as) : '';
  return (
    <div class="actions">
      <Copying copied={words.copied} refused={(failed) => `${words.copyFailed} ${failed}`} of={text}>
        {(copy) => (
          <>
            <CopyFrame onCopy={copy(() => text)}>
              {words.copy} <span class="mono">{text.length > SHOWN ? `${text.slice(0, SHOWN)}…` : text}</span>
            </CopyFrame>
            <FormatChoice />
            <span>
              {words.explanation}{' '}
              <button type="button" onClick={copy(explanation('markdown'))}>
                {words.markdown}
              </button>{' '}
              <button type="button" onClick={copy(explanation('table'))}>
                {words.table}
              </button>
            </span>
          </>
        )}
      </Copying>
    </div>
  );
}

function CopyFrame({ onCopy, children }: { readonly onCopy: () => void; readonly children: ComponentChildren }) {
  useCommand('copy-frame', onCopy);
  return (
    <button type="button" class="first" onClick={onCopy} {...useKeyOf('copy-frame')}>
      {children}
    </button>
  );
}

/** The formats in which the current frame can be copied, with its checksum or without. */
function FormatChoice() {
  const words = useWords('tools');
  const { format, checksum } = copyChoice.value;
  const possible = useSteady(() => {
    const { reading } = evaluation.value.frame ?? {};
    return (
      reading && { formats: copyFormats.filter((each) => canCopyAs(reading, each)), checksum: hasChecksum(reading) }
    );
  }).value;
  return (
    <>
      <label>
        {words.copyAs}{' '}
        <Select
          value={format}
          options={copyFormats.map((value) => ({
            value,
            name: words.formats[value],
            disabled: !possible?.formats.includes(value),
          }))}
          onChoose={(chosen) => choose({ format: chosen })}
        />
      </label>
      {possible?.checksum && (
        <label class="tick">
          <input
            type="checkbox"
            checked={checksum}
            onChange={({ currentTarget }) => choose({ checksum: currentTarget.checked })}
          />{' '}
          {words.withChecksum}
        </label>
      )}
    </>
  );
}
