import { useId, useLayoutEffect, useRef, useState } from 'preact/hooks';
import './combobox.css';
import { saidId } from './field.tsx';

interface Option<T> {
  readonly key: string;
  readonly name: string;
  readonly value: T;
}

interface ComboboxProps<T> {
  readonly id: string;
  /** What stands here while nothing is typed: the name of the value. */
  readonly text: string;
  readonly wrong?: boolean;
  /** The options that a text finds, the best first; a blank text has all. */
  readonly find: (text: string) => readonly Option<T>[];
  /** What is said if a text finds nothing. */
  readonly nothing: string;
  readonly onChoose: (value: T) => void;
}

/**
 * One of many values, found by typing: arrows move, Enter and Tab take what is marked, Escape gives back what stood there.
 * It stands inside a `Field` of the same id.
 */
export function Combobox<T>({ id, text, wrong, find, nothing, onChoose }: ComboboxProps<T>) {
  const list = useId();
  const [typed, setTyped] = useState<string | undefined>(undefined);
  const [open, setOpen] = useState(false);
  const [at, setAt] = useState(0);
  const marked = useRef<HTMLDivElement>(null);
  const box = useRef<HTMLDivElement>(null);
  const options = open ? find(typed ?? '') : [];
  const here = options[at];
  useLayoutEffect(() => marked.current?.scrollIntoView?.({ block: 'nearest' }), [open, at, typed]);
  useLayoutEffect(() => {
    if (open && box.current) placeOptions(box.current);
  }, [open]);
  const close = () => {
    setOpen(false);
    setTyped(undefined);
  };
  const show = () => {
    setOpen(true);
    setAt(Math.max(0, typed === undefined ? find('').findIndex(({ name }) => name === text) : at));
  };
  const choose = (option: Option<T> | undefined) => {
    close();
    if (option) onChoose(option.value);
  };
  /** Does what a key is for. Answers whether the input is to do no more. */
  const press = (key: string): boolean => {
    switch (key) {
      case 'ArrowDown':
      case 'ArrowUp':
        if (open) setAt(Math.max(0, Math.min(at + (key === 'ArrowDown' ? 1 : -1), options.length - 1)));
        else show();
        return true;
      case 'Enter':
        if (open) choose(here);
        return open;
      case 'Tab':
        if (typed !== undefined) choose(here);
        return false;
      case 'Escape':
        close();
        return open;
      default:
        return false;
    }
  };
  return (
    <div class="combobox">
      <input
        id={id}
        role="combobox"
        aria-autocomplete="list"
        aria-expanded={open}
        aria-controls={list}
        aria-activedescendant={here && `${list}-${at}`}
        aria-invalid={wrong}
        aria-describedby={saidId(id)}
        autocomplete="off"
        spellcheck={false}
        autocapitalize="off"
        value={typed ?? text}
        onFocusIn={({ currentTarget }) => currentTarget.select()}
        onFocusOut={close}
        onClick={() => open || show()}
        onInput={({ currentTarget }) => {
          setTyped(currentTarget.value);
          setOpen(true);
          setAt(0);
        }}
        onKeyDown={(event) => {
          if (event.ctrlKey || event.metaKey || event.altKey || event.isComposing) return;
          if (press(event.key)) event.preventDefault();
        }}
      />
      <div ref={box} class="options" id={list} role="listbox" hidden={!open}>
        {options.map((option, index) => (
          // biome-ignore lint/a11y/useKeyWithClickEvents: the keys are the input's.
          <div
            key={option.key}
            id={`${list}-${index}`}
            role="option"
            tabIndex={-1}
            aria-selected={index === at}
            ref={index === at ? marked : null}
            // The input keeps the focus.
            onPointerDown={(event) => event.preventDefault()}
            onClick={() => choose(option)}
          >
            {option.name}
          </div>
        ))}
        {open && options.length === 0 && <div class="soft">{nothing}</div>}
      </div>
    </div>
  );
}

/** The least room for options below the input, in pixels, before they stand above it. */
const ROOM = 200;

/** Puts the options where the window has room for them: below the input, or above it. */
function placeOptions(box: HTMLElement): void {
  const input = box.previousElementSibling?.getBoundingClientRect();
  if (input === undefined) return;
  const below = document.documentElement.clientHeight - input.bottom;
  const above = below < ROOM && input.top > below;
  box.classList.toggle('above', above);
  box.style.maxHeight = `${Math.min(384, (above ? input.top : below) - 8)}px`;
}
