import type { ComponentChildren, TargetedKeyboardEvent } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import type { OpenMenu } from './menu.tsx';

export interface MenuItem {
  readonly id: string;
  readonly name: ComponentChildren;
  /** Said softly behind the name. */
  readonly hint?: ComponentChildren;
  /** For what is on or off: it stays open when it is changed. */
  readonly checked?: boolean;
  readonly run: () => void;
}

interface MenuListProps {
  readonly menu: OpenMenu;
  readonly items: readonly MenuItem[];
}

/** The acts of an open menu. Arrow keys and letters go through them, Escape closes it. */
export function MenuList({ menu, items }: MenuListProps) {
  const list = useRef<HTMLDivElement>(null);
  const itemsOf = () => [...(list.current?.querySelectorAll<HTMLElement>('[role^="menuitem"]') ?? [])];
  useLayoutEffect(() => {
    menu.place();
    itemsOf()[0]?.focus();
  }, []);
  const press = (event: TargetedKeyboardEvent<HTMLElement>) => {
    const all = itemsOf();
    const to = all[itemForKey(event.key, all, document.activeElement)];
    if (to === undefined && event.key !== 'Escape' && event.key !== 'Tab') return;
    // The focus comes back to the button, from where Tab goes on.
    if (event.key !== 'Tab') event.preventDefault();
    if (to) to.focus();
    else menu.close();
  };
  return (
    <div ref={list} role="menu" aria-label={menu.label} onKeyDown={press}>
      {items.map((item) => (
        // biome-ignore lint/a11y/useAriaPropsSupportedByRole: only an item that is on or off has the attribute.
        <button
          key={item.id}
          type="button"
          role={item.checked === undefined ? 'menuitem' : 'menuitemcheckbox'}
          aria-checked={item.checked}
          tabIndex={-1}
          onClick={() => {
            if (item.checked === undefined) menu.close();
            item.run();
          }}
        >
          {item.checked !== undefined && <span aria-hidden="true">{item.checked ? '☑ ' : '☐ '}</span>}
          {item.name}
          {item.hint !== undefined && <small>{item.hint}</small>}
        </button>
      ))}
    </div>
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
