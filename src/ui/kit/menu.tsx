import type { ComponentChildren } from 'preact';
import { useId, useLayoutEffect, useRef, useState } from 'preact/hooks';
import './menu.css';
import { placeBelow } from './place-below.ts';

/** What the list of an open menu needs of it. */
export interface OpenMenu {
  readonly label: string;
  readonly close: () => void;
  /** Puts it beside its button, once the list gives it its size. */
  readonly place: () => void;
}

interface MenuProps {
  /** What the button opens, for those who hear it. */
  readonly label: string;
  readonly class?: string;
  /** What stands on the button. */
  readonly children: ComponentChildren;
  /** What it holds, made when it is opened: a `MenuList`, which may come later. */
  readonly list: (menu: OpenMenu) => ComponentChildren;
}

/** A button with a list of acts, each done at once. */
export function Menu({ label, class: name = '', children, list }: MenuProps) {
  const id = useId();
  const button = useRef<HTMLButtonElement>(null);
  const box = useRef<HTMLDivElement>(null);
  const [open, setOpen] = useState(false);
  const place = () => placeBelow(button.current, box.current);
  useLayoutEffect(() => {
    if (open) place();
  }, [open]);
  const close = () => {
    box.current?.hidePopover();
    button.current?.focus();
  };
  return (
    <>
      <button
        ref={button}
        type="button"
        class={name}
        aria-label={label}
        aria-haspopup="menu"
        aria-expanded={open}
        popovertarget={id}
      >
        {children}
      </button>
      <div ref={box} id={id} class="menu" popover="auto" onToggle={({ newState }) => setOpen(newState === 'open')}>
        {open && list({ label, close, place })}
      </div>
    </>
  );
}
