import { useLayoutEffect, useRef } from 'preact/hooks';
import { disabledFor } from '../../kit/disabled-for.ts';
import { FileButton } from '../../kit/file-button.tsx';
import { useCommand } from '../../parts/commands.ts';
import { openFile, pasted } from '../../parts/pasted.ts';
import { part, Slot } from '../../parts/slot.tsx';
import { commit, page } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { Chips } from './chips.tsx';
import './input.css';
import { useTyping } from './use-typing.ts';

/** A longer text, in characters, is shown by its beginning: a field with all of it would stop the page. */
const SHOWN = 5_000;

const said = part(
  ['read'],
  () => import('./said.tsx'),
  ({ Said }) => Said,
);

/** The one input: a frame, a log, code, or what a person calls a register or a function. What it was taken for stands below it. */
export function InputPlace() {
  const words = useWords('input');
  const area = useRef<HTMLTextAreaElement>(null);
  const { text, type, read } = useTyping();
  const cut = text.length > SHOWN;
  useLayoutEffect(() => {
    if (isFresh() && matchMedia('(pointer: fine)').matches) area.current?.focus({ preventScroll: true });
  }, []);
  useCommand('focus-input', () => {
    area.current?.focus();
    area.current?.select();
  });
  const select = (start: number, end: number) => {
    area.current?.focus();
    area.current?.setSelectionRange(start, end);
  };
  const go = (event: KeyboardEvent) => {
    if (event.key === 'Escape') area.current?.blur();
    else if (event.key === 'Enter' && !event.shiftKey && !event.isComposing) {
      read('edit');
      const meant = page.meant.peek();
      const [first] = meant.kind === 'several' ? meant.offers : [];
      if (first) page.choose(first);
      else commit();
    } else return;
    event.preventDefault();
  };
  // What the field does not show in full is replaced by what is pasted into it.
  const replace = (event: ClipboardEvent) => {
    const given = event.clipboardData?.getData('text/plain') ?? '';
    if (given.trim() === '' || (!cut && given.length <= SHOWN)) return;
    event.preventDefault();
    page.takeInput(given, 'step');
  };
  return (
    <section class="ask" aria-label={words.section}>
      <div class="ask-field">
        <label class="unseen" for="input">
          {words.label}
        </label>
        <textarea
          ref={area}
          id="input"
          class="mono"
          placeholder={words.hint}
          readOnly={cut}
          rows={2}
          spellcheck={false}
          autocomplete="off"
          autocapitalize="off"
          value={text.slice(0, SHOWN)}
          onInput={({ currentTarget, inputType }) =>
            type(currentTarget.value, inputType === 'insertFromPaste' ? 'step' : 'edit')
          }
          onPaste={replace}
          onKeyDown={go}
          onBlur={() => {
            read('edit');
            commit();
          }}
        />
        <div class="ask-actions">
          <FileButton label={words.openFile} onFile={(file) => void openFile(file)} />
          <button
            type="button"
            {...disabledFor(text === '' ? words.isEmpty : undefined)}
            onClick={() => page.takeInput('', 'step')}
          >
            {words.clear}
          </button>
        </div>
      </div>
      <div class="ask-said" aria-live="polite">
        {cut && <p class="said">{words.beginning(text.length)}</p>}
        {pasted.state.value.kind === 'empty' ? (
          <p class="said">{words.stays}</p>
        ) : (
          <Slot part={said} with={{ onShow: select }} />
        )}
      </div>
      <Chips />
    </section>
  );
}

let begun = false;

/** Whether the page has just been opened, without a link to a frame and with nothing in the input. */
function isFresh(): boolean {
  const first = !begun;
  begun = true;
  return first && location.hash === '' && page.input.peek() === '' && document.activeElement === document.body;
}
