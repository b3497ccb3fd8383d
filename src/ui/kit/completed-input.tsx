import { Fragment } from 'preact';
import { useId, useLayoutEffect, useRef, useState } from 'preact/hooks';
import './completed-input.css';
import { OptionList, optionId } from './option-list.tsx';

/** What may stand in the place of the characters `[from, to)`. */
interface Completing {
  readonly text: string;
  readonly from: number;
  readonly to: number;
  /** Said softly behind the text. */
  readonly hint?: string;
  /** Whether it is only a beginning: more is offered behind it. */
  readonly goesOn: boolean;
}

interface CompletedInputProps {
  readonly id: string;
  readonly text: string;
  readonly placeholder?: string;
  /** What is offered, for those who hear it. */
  readonly offered: string;
  /** What the text may become at the caret. */
  readonly complete: (text: string, caret: number) => readonly Completing[];
  /** The places of the text in which something is wrong; what is wrong stands in the element `describedBy`. */
  readonly wrong: readonly { readonly from: number; readonly to: number }[];
  readonly describedBy?: string | undefined;
  readonly onText: (text: string) => void;
  /** The caret, or `undefined` when the input loses the focus. */
  readonly onCaret: (caret: number | undefined) => void;
}

/**
 * A text that is completed while it is typed. Arrows go through what is offered; Enter and Tab take what they have come to; Escape closes
 * the list, and empties the text where no list is open.
 */
export function CompletedInput(props: CompletedInputProps) {
  const { id, text, placeholder, offered, complete, wrong, describedBy, onText, onCaret } = props;
  const list = useId();
  const input = useRef<HTMLInputElement>(null);
  const marks = useRef<HTMLDivElement>(null);
  const [caret, setCaret] = useState(0);
  const [isOpen, setOpen] = useState(false);
  const [at, setAt] = useState(-1);
  /** Where the caret stands once the text has been completed. */
  const goes = useRef<number | undefined>(undefined);
  const options = isOpen ? complete(text, Math.min(caret, text.length)) : [];
  const open = options.length > 0;
  const move = (to: number | undefined) => {
    if (to !== undefined) setCaret(to);
    onCaret(to);
  };
  useLayoutEffect(() => {
    const { current } = goes;
    goes.current = undefined;
    if (current !== undefined) input.current?.setSelectionRange(current, current);
    follow();
  }, [text]);
  const follow = () => {
    if (marks.current && input.current) marks.current.style.translate = `${-input.current.scrollLeft}px`;
  };
  const take = (option: Completing | undefined) => {
    if (option === undefined) return;
    const { from, to } = option;
    goes.current = from + option.text.length;
    setAt(-1);
    setOpen(option.goesOn);
    move(goes.current);
    onText(text.slice(0, from) + option.text + text.slice(to));
  };
  /** Does what a key is for. Answers whether the input is to do no more. */
  const press = (key: string): boolean => {
    switch (key) {
      case 'ArrowDown':
        setOpen(true);
        setAt(open ? Math.min(at + 1, options.length - 1) : 0);
        return true;
      case 'ArrowUp':
        if (open) setAt(Math.max(at - 1, -1));
        return open;
      case 'Enter':
        if (open && at >= 0) take(options[at]);
        else setOpen(false);
        return true;
      case 'Tab':
        if (open && at >= 0) take(options[at]);
        return false;
      case 'Escape':
        setOpen(false);
        setAt(-1);
        if (!open && text !== '') onText('');
        return open || text !== '';
      default:
        return false;
    }
  };
  return (
    <div class="combobox completed">
      <input
        ref={input}
        id={id}
        class="mono"
        role="combobox"
        aria-autocomplete="list"
        aria-expanded={open}
        aria-controls={list}
        aria-activedescendant={open && at >= 0 ? optionId(list, at) : undefined}
        aria-invalid={wrong.length > 0}
        aria-describedby={describedBy}
        autocomplete="off"
        spellcheck={false}
        autocapitalize="off"
        placeholder={placeholder}
        value={text}
        onInput={({ currentTarget }) => {
          setOpen(true);
          setAt(-1);
          move(currentTarget.selectionStart ?? currentTarget.value.length);
          onText(currentTarget.value);
        }}
        onSelect={({ currentTarget }) => move(currentTarget.selectionStart ?? 0)}
        onFocusOut={() => {
          setOpen(false);
          setAt(-1);
          move(undefined);
        }}
        onClick={() => setOpen(true)}
        onScroll={follow}
        onKeyDown={(event) => {
          if (event.ctrlKey || event.metaKey || event.altKey || event.isComposing) return;
          if (press(event.key)) event.preventDefault();
        }}
      />
      <div class="wrong-places mono" aria-hidden="true">
        <div ref={marks}>{placed(text, wrong)}</div>
      </div>
      <OptionList
        id={list}
        label={offered}
        open={open}
        options={options.map((option) => ({
          key: option.text,
          name: (
            <>
              <span class="mono">{option.text}</span>
              {option.hint !== undefined && <small>{option.hint}</small>}
            </>
          ),
        }))}
        at={at}
        onChoose={(index) => take(options[index])}
      />
    </div>
  );
}

/** A text in which places are marked, that are in order and apart. */
function placed(text: string, places: CompletedInputProps['wrong']) {
  let end = 0;
  return places.map(({ from, to }) => {
    const before = text.slice(end, from);
    end = to;
    return (
      <Fragment key={from}>
        {before}
        <mark>{text.slice(from, to)}</mark>
      </Fragment>
    );
  });
}
