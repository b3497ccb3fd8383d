import type { ComponentChildren, TargetedKeyboardEvent } from 'preact';
import { useId, useLayoutEffect, useRef, useState } from 'preact/hooks';
import './menu.css';
import { placeBelow } from './place-below.ts';

export interface MenuItem {
  readonly id: string;
  readonly name: ComponentChildren;
  /** Said softly behind the name. */
  readonly hint?: ComponentChildren;
  /** For what is on or off: it stays open when it is changed. */
  readonly checked?: boolean;
  readonly run: () => void;
}

interface MenuProps {
  /** What the button opens, for those who hear it. */
  readonly label: string;
  readonly class?: string;
  /** What stands on the button. */
  readonly children: ComponentChildren;
  /** What it holds, made when it is opened. */
  readonly items: () => readonly MenuItem[];
  readonly disabled?: boolean;
  readonly title?: string;
}

/** A button with a list of acts, each done at once. Arrow keys and letters go through it, Escape closes it. */
export function Menu({ label, class: name = '', children, items, disabled, title }: MenuProps) {
  const id = useId();
  const button = useRef<HTMLButtonElement>(null);
  const list = useRef<HTMLDivElement>(null);
  const [open, setOpen] = useState(false);
  const itemsOf = () => [...(list.current?.querySelectorAll<HTMLElement>('[role^="menuitem"]') ?? [])];
  useLayoutEffect(() => {
    if (!open) return;
    placeBelow(button.current, list.current);
    itemsOf()[0]?.focus();
  }, [open]);
  const close = () => {
    list.current?.hidePopover();
    button.current?.focus();
  };
  const press = (event: TargetedKeyboardEvent<HTMLElement>) => {
    const all = itemsOf();
    const to = all[itemForKey(event.key, all, document.activeElement)];
    if (to === undefined && event.key !== 'Escape' && event.key !== 'Tab') return;
    // The focus comes back to the button, from where Tab goes on.
    if (event.key !== 'Tab') event.preventDefault();
    if (to) to.focus();
    else close();
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
        disabled={disabled}
        title={title}
      >
        {children}
      </button>
      <div
        ref={list}
        id={id}
        class="menu"
        role="menu"
        aria-label={label}
        popover="auto"
        onKeyDown={press}
        onToggle={({ newState }) => setOpen(newState === 'open')}
      >
        {open &&
          items().map((item) => (
            // biome-ignore lint/a11y/useAriaPropsSupportedByRole: only an item that is on or off has the attribute.
            <button
              key={item.id}
              type="button"
              role={item.checked === undefined ? 'menuitem' : 'menuitemcheckbox'}
              aria-checked={item.checked}
              tabIndex={-1}
              onClick={() => {
                if (item.checked === undefined) close();
                item.run();
              }}
            >
              {item.checked !== undefined && <span aria-hidden="true">{item.checked ? '☑ ' : '☐ '}</span>}
              {item.name}
              {item.hint !== undefined && <small>{item.hint}</small>}
            </button>
          ))}
      </div>
    </>
  );
}

/** The item a key leads to; −1 for keys that lead nowhere. */
function itemForKey(key: string, all: readonly HTMLElement[], now: Element | null): number {
  const at = all.indexOf(now as HTMLElement);
  if (key === 'ArrowDown') return (at + 1) % all.length;
  if (key === 'ArrowUp') return (at - 1 + all.length) % all.length;
  if (key === 'Home') return 0;
  if (key === 'End') return all.length - 1;
  if (key.length !== 1 || key === ' ') return -1;
  const begins = (item: HTMLElement) => item.textContent.trim().toLowerCase().startsWith(key.toLowerCase());
  const behind = all.findIndex((item, index) => index > at && begins(item));
  return behind < 0 ? all.findIndex(begins) : behind;
}
