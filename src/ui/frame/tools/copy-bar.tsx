import { Component, type ComponentChildren } from 'preact';
import type { Reading } from '../../../modbus/index.ts';
import { KeptChoice } from '../../../store/index.ts';
import type { ToolWords } from '../../../words/index.ts';
import {
  type CopyFormat,
  canCopyAs,
  copyFormats,
  copyText,
  explanationText,
  type FrameNames,
  firstCopyChoice,
  hasChecksum,
  readCopyChoice,
} from '../../../workbench/index.ts';
import { Select } from '../../kit/choice.tsx';
import { Copying } from '../../kit/copy-button.tsx';
import { useCommand, useKeyOf } from '../../parts/commands.ts';
import { explanationWords } from '../../parts/explanation/explanation-words.ts';
import { words as pageWords } from '../../parts/page-words.ts';
import { storage } from '../../parts/store.ts';

/** The format copied last. */
const copyChoice = new KeptChoice(storage, 'copy', firstCopyChoice, readCopyChoice);

/** Longest text shown on the button itself. */
const SHOWN = 24;

interface CopyProps {
  readonly reading: Reading;
  readonly bytes: Uint8Array;
  readonly words: ToolWords;
  readonly names: FrameNames | undefined;
}

/** Copies the frame in the format used last, or in any other, and its explanation. */
export class CopyBar extends Component<CopyProps> {
  private choose(format: CopyFormat, checksum: boolean): void {
    copyChoice.value = { format, checksum };
  }

  private explanation(as: 'markdown' | 'table'): string {
    const { words, ...of } = this.props;
    return explanationText({ ...of, words: explanationWords(words) }, pageWords.page.columns, as);
  }

  render() {
    const { reading, bytes, words } = this.props;
    const { format, checksum } = copyChoice.value;
    const text = copyText(reading, bytes, copyChoice.value) ?? copyText(reading, bytes, { format: 'spaced', checksum });
    return (
      <div class="actions">
        <Copying copied={words.copied} refused={(failed) => `${words.copyFailed} ${failed}`} of={bytes}>
          {(copy) => (
            <>
              <CopyFrame onCopy={copy(() => text ?? '')}>
                {words.copy} <span class="mono">{text && text.length > SHOWN ? `${text.slice(0, SHOWN)}…` : text}</span>
              </CopyFrame>
              <label>
                {words.copyAs}{' '}
                <Select
                  value={format}
                  options={copyFormats.map((value) => ({
                    value,
                    name: words.formats[value],
                    disabled: !canCopyAs(reading, value),
                  }))}
                  onChoose={(chosen) => this.choose(chosen, checksum)}
                />
              </label>
              {hasChecksum(reading) && (
                <label class="tick">
                  <input
                    type="checkbox"
                    checked={checksum}
                    onChange={({ currentTarget }) => this.choose(format, currentTarget.checked)}
                  />{' '}
                  {words.withChecksum}
                </label>
              )}
              <span>
                {words.explanation}{' '}
                <button type="button" onClick={copy(() => this.explanation('markdown'))}>
                  {words.markdown}
                </button>{' '}
                <button type="button" onClick={copy(() => this.explanation('table'))}>
                  {words.table}
                </button>
              </span>
            </>
          )}
        </Copying>
      </div>
    );
  }
}

function CopyFrame({ onCopy, children }: { readonly onCopy: () => void; readonly children: ComponentChildren }) {
  useCommand('copy-frame', onCopy);
  return (
    <button type="button" class="first" onClick={onCopy} {...useKeyOf('copy-frame')}>
      {children}
    </button>
  );
}
