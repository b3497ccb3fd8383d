import { Component, createRef } from 'preact';
import { FileButton } from '../../kit/file-button.tsx';
import { FoldPanel } from '../../kit/fold.tsx';
import { cancel, opened, pasted, read } from '../../parts/pasted.ts';
import { Slot } from '../../parts/slot.tsx';
import { commit } from '../../parts/store.ts';
import { Notation } from './notation.tsx';
import { readWords as words } from './read-words.ts';
import { Excerpt, TextProblems } from './text-problems.tsx';
import { WhatItIs } from './what-it-is.tsx';

/** The list comes, with what draws long lists, when a text has more than one frame. */
const loadList = () => import('./frame-list.tsx').then(({ FrameList }) => FrameList);

/** Typing is read at a pause of this many milliseconds. */
const PAUSE = 150;
/** A longer text, in characters, is shown by its beginning: a field with all of it would stop the page. */
const SHOWN = 100_000;
const MEGABYTE = 1_000_000;

const sizeOf = ({ length }: string) =>
  length < MEGABYTE ? `${Math.ceil(length / 1000)} kB` : `${(length / MEGABYTE).toFixed(1)} MB`;

const clear = () => read('', 'edit');

/** Where anything is pasted: the text, what it was read as, its frames, and what each of them is. */
export class ReadPanel extends Component<object, { typed?: string | undefined }> {
  private readonly area = createRef<HTMLTextAreaElement>();
  private pause: ReturnType<typeof setTimeout> | undefined;

  private readonly type = (typed: string) => {
    this.setState({ typed });
    clearTimeout(this.pause);
    this.pause = setTimeout(() => this.readNow(), PAUSE);
  };

  private readonly readNow = () => {
    clearTimeout(this.pause);
    const { typed } = this.state;
    if (typed === undefined) return;
    this.setState({ typed: undefined });
    read(typed, 'edit');
  };

  private readonly show = (start: number, end: number) => {
    this.area.current?.focus();
    this.area.current?.setSelectionRange(start, end);
  };

  render() {
    const state = pasted.value;
    const { typed } = this.state;
    const text = typed ?? (state.kind === 'read' ? state.reading.text : state.kind === 'empty' ? '' : state.text);
    // What is typed and not read yet has no reading that could be shown beside it.
    const reading = typed === undefined && state.kind === 'read' ? state.reading : undefined;
    return (
      <FoldPanel
        class="read-panel"
        title={words.title}
        hint={words.intro}
        open={opened.value}
        onToggle={(open) => {
          opened.value = open;
        }}
      >
        <div class="read-text">
          <textarea
            ref={this.area}
            class="mono"
            aria-label={words.text}
            readOnly={text.length > SHOWN}
            rows={Math.min(12, Math.max(3, text.slice(0, 4000).split('\n').length))}
            spellcheck={false}
            autocomplete="off"
            autocapitalize="off"
            wrap={text.length > 20_000 ? 'off' : 'soft'}
            value={text.slice(0, SHOWN)}
            onInput={({ currentTarget }) => this.type(currentTarget.value)}
            onBlur={() => {
              this.readNow();
              commit();
            }}
          />
          {text.length > SHOWN && <p class="said">{words.beginning(sizeOf(text))}</p>}
          <div class="read-actions">
            <FileButton
              label={words.openFile}
              onFile={(file) => void file.text().then((content) => read(content, 'step'))}
            />
            <button type="button" disabled={text === ''} onClick={clear}>
              {words.clear}
            </button>
          </div>
        </div>
        <div aria-live="polite">
          {state.kind === 'reading' && (
            <p class="read-progress">
              <progress aria-label={words.reading(sizeOf(state.text))} /> {words.reading(sizeOf(state.text))}{' '}
              <button type="button" onClick={cancel}>
                {words.cancel}
              </button>
            </p>
          )}
          {typed === undefined && state.kind === 'failed' && <p class="said">{words.failed}</p>}
          {reading && <Notation reading={reading} />}
        </div>
        {reading && state.kind === 'read' && (
          <>
            <TextProblems reading={reading} onShow={this.show} />
            {reading.items.length > 1 && <Slot part={loadList} with={{ reading, chosen: state.chosen }} />}
            <Excerpt reading={reading} chosen={state.chosen} />
            <WhatItIs reading={reading} chosen={state.chosen} />
          </>
        )}
      </FoldPanel>
    );
  }
}
