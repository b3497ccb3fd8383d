import type { RefObject } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';

interface Focusing<E> {
  /** The element that holds all that may get the focus. */
  readonly root: RefObject<E | null>;
  readonly focus: (name: string) => void;
}

/** Gives the focus to an element by its `data-focus` after the next drawing: the one that had it may be gone then. */
export function useFocus<E extends HTMLElement>(): Focusing<E> {
  const root = useRef<E>(null);
  const wanted = useRef<string>(undefined);
  useLayoutEffect(() => {
    if (wanted.current === undefined) return;
    root.current?.querySelector<HTMLElement>(`[data-focus="${CSS.escape(wanted.current)}"]`)?.focus();
    wanted.current = undefined;
  });
  return {
    root,
    focus: (name) => {
      wanted.current = name;
    },
  };
}
