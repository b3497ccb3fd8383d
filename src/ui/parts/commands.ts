import { useLayoutEffect, useRef } from 'preact/hooks';
import type { CommandId, OfferedId } from '../../store/index.ts';
import { commands } from './store.ts';
import { useWords } from './words.ts';

const TYPED_IN = 'input:not([type=checkbox], [type=radio], [type=button]), textarea, select, [contenteditable]';

/** Hears every key and does what it is for. */
export function listenForKeys(): void {
  addEventListener('keydown', (event) => {
    if (event.isComposing) return;
    const done = commands.press({
      key: event.key,
      ctrl: event.ctrlKey || event.metaKey,
      alt: event.altKey,
      shift: event.shiftKey,
      typing: event.target instanceof Element && event.target.matches(TYPED_IN),
      taken: event.defaultPrevented || document.querySelector('dialog[open], :popover-open') !== null,
    });
    // Escape closes dialogs too.
    if (done && event.key !== 'Escape') event.preventDefault();
  });
}

/** Offers a command while the component stands and there is something to do. */
export function useCommand(id: OfferedId, run: (() => void) | undefined): void {
  const latest = useRef(run);
  latest.current = run;
  const can = run !== undefined;
  useLayoutEffect(() => (can ? commands.offer(id, () => latest.current?.()) : undefined), [id, can]);
}

/** What a button that does a command says of its key, as a tooltip and to screen readers. */
export function useKeyOf(id: CommandId): { readonly title: string; readonly 'aria-keyshortcuts': string } | undefined {
  const { keyText } = useWords('page').views;
  const key = commands.keyOf(id);
  // Browsers name the keys of the attribute as they name keys that were pressed.
  return key === undefined ? undefined : { title: keyText(key), 'aria-keyshortcuts': key.replace('Ctrl', 'Control') };
}
