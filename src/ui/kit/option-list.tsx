import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import './combobox.css';

interface ListedOption {
  readonly key: string;
  readonly name: ComponentChildren;
}

interface OptionListProps {
  readonly id: string;
  /** What is listed, for those who hear it. */
  readonly label?: string | undefined;
  readonly open: boolean;
  readonly options: readonly ListedOption[];
  /** The one that the keys have come to; −1 for none. */
  readonly at: number;
  /** What it says if it has no options. */
  readonly nothing?: string;
  readonly onChoose: (at: number) => void;
}

/** The id of an option of a list. */
export const optionId = (list: string, at: number): string => `${list}-${at}`;

/** What an input offers, below it or above it: right behind the input, whose keys go through it. */
export function OptionList({ id, label, open, options, at, nothing, onChoose }: OptionListProps) {
  const marked = useRef<HTMLDivElement>(null);
  const box = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => marked.current?.scrollIntoView?.({ block: 'nearest' }), [open, at, options[at]?.key]);
  useLayoutEffect(() => {
    if (open && box.current) placeOptions(box.current);
  }, [open]);
  return (
    <div ref={box} class="options" id={id} role="listbox" aria-label={label} hidden={!open}>
      {options.map((option, index) => (
        // biome-ignore lint/a11y/useKeyWithClickEvents: the keys are the input's.
        <div
          key={option.key}
          id={optionId(id, index)}
          role="option"
          tabIndex={-1}
          aria-selected={index === at}
          ref={index === at ? marked : null}
          // The input keeps the focus.
          onPointerDown={(event) => event.preventDefault()}
          onClick={() => onChoose(index)}
        >
          {option.name}
        </div>
      ))}
      {open && options.length === 0 && nothing !== undefined && <div class="soft">{nothing}</div>}
    </div>
  );
}

/** The least room for options below the input, in pixels, before they stand above it. */
const ROOM = 200;

/** Puts the options where the window has room for them: below the input, or above it. */
function placeOptions(box: HTMLElement): void {
  const input = box.parentElement?.getBoundingClientRect();
  if (input === undefined) return;
  const below = document.documentElement.clientHeight - input.bottom;
  const above = below < ROOM && input.top > below;
  box.classList.toggle('above', above);
  box.style.maxHeight = `${Math.min(384, (above ? input.top : below) - 8)}px`;
}
