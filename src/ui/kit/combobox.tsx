import { useId, useState } from 'preact/hooks';
import { saidId } from './field.tsx';
import { OptionList, optionId } from './option-list.tsx';

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
  const options = open ? find(typed ?? '') : [];
  const here = options[at];
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
        aria-activedescendant={here && optionId(list, at)}
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
      <OptionList
        id={list}
        open={open}
        options={options}
        at={at}
        nothing={nothing}
        onChoose={(index) => choose(options[index])}
      />
    </div>
  );
}
