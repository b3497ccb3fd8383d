import { useEffect, useRef, useState } from 'preact/hooks';
import { FileButton } from '../../kit/file-button.tsx';
import { pasted } from '../../parts/pasted.ts';
import { part, Slot } from '../../parts/slot.tsx';
import { commit } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { Notation } from './notation.tsx';
import './read.css';
import { Excerpt, TextProblems } from './text-problems.tsx';
import { WhatItIs } from './what-it-is.tsx';

/** The list, and the code that draws long lists, come when a text has more than one frame. */
const list = part(
  ['read'],
  () => import('./frame-list.tsx'),
  ({ FrameList }) => FrameList,
);

/** Typing is read at a pause of this many milliseconds. */
const PAUSE = 150;
/** A longer text, in characters, is shown by its beginning: a field with all of it would stop the page. */
const SHOWN = 100_000;

/** The pasted text, what it was read as, its frames, and what each of them is. The text has the focus each time it is asked for. */
export function ReadPanel({ asked }: { readonly asked: number }) {
  const words = useWords('read');
  const state = pasted.state.value;
  const [typed, setTyped] = useState<string>();
  const pause = useRef<ReturnType<typeof setTimeout>>(undefined);
  const area = useRef<HTMLTextAreaElement>(null);
  useEffect(() => {
    if (asked > 0) area.current?.focus();
  }, [asked]);
  const text = typed ?? (state.kind === 'read' ? state.reading.text : state.kind === 'empty' ? '' : state.text);
  const read = (now: string | undefined) => {
    clearTimeout(pause.current);
    if (now === undefined) return;
    setTyped(undefined);
    pasted.read(now, 'edit');
  };
  const type = (next: string) => {
    setTyped(next);
    clearTimeout(pause.current);
    pause.current = setTimeout(() => read(next), PAUSE);
  };
  const select = (start: number, end: number) => {
    area.current?.focus();
    area.current?.setSelectionRange(start, end);
  };
  return (
    <>
      <div class="read-text">
        <textarea
          ref={area}
          class="mono"
          aria-label={words.text}
          readOnly={text.length > SHOWN}
          rows={Math.min(12, Math.max(3, text.slice(0, 4000).split('\n').length))}
          spellcheck={false}
          autocomplete="off"
          autocapitalize="off"
          wrap={text.length > 20_000 ? 'off' : 'soft'}
          value={text.slice(0, SHOWN)}
          onInput={({ currentTarget }) => type(currentTarget.value)}
          onBlur={() => {
            read(typed);
            commit();
          }}
        />
        {text.length > SHOWN && <p class="said">{words.beginning(text.length)}</p>}
        <div class="read-actions in-row">
          <FileButton
            label={words.openFile}
            onFile={(file) => void file.text().then((content) => pasted.read(content, 'step'))}
          />
          <button type="button" disabled={text === ''} onClick={() => pasted.read('', 'edit')}>
            {words.clear}
          </button>
        </div>
      </div>
      <div aria-live="polite">
        {state.kind === 'reading' && (
          <p class="read-progress">
            <progress aria-label={words.reading(state.text.length)} /> {words.reading(state.text.length)}{' '}
            <button type="button" onClick={pasted.cancel}>
              {words.cancel}
            </button>
          </p>
        )}
        {typed === undefined && state.kind === 'failed' && <p class="said">{words.failed}</p>}
        {typed === undefined && state.kind === 'read' && <Notation reading={state.reading} />}
      </div>
      {/* What is typed and not read yet has no reading that could be shown beside it. */}
      {typed === undefined && state.kind === 'read' && (
        <>
          <TextProblems reading={state.reading} onShow={select} />
          {state.reading.items.length > 1 && <Slot part={list} with={state} />}
          <Excerpt {...state} />
          <WhatItIs />
        </>
      )}
    </>
  );
}
