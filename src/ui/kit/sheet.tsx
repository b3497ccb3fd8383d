import type { ComponentChildren } from 'preact';
import { useId, useLayoutEffect, useRef } from 'preact/hooks';
import './sheet.css';

interface SheetProps {
  readonly title: string;
  /** What the button says that closes it. */
  readonly close: string;
  readonly onClose: () => void;
  readonly onKey?: (event: KeyboardEvent & { readonly currentTarget: HTMLElement }) => void;
  readonly children: ComponentChildren;
}

/**
 * A sheet at the side of the page, or at the foot of a narrow one, there as long as it is drawn. The page beside it is used as
 * before. It takes the focus; when it is taken away with the focus in it, that goes back to where it was.
 */
export function Sheet({ title, close, onClose, onKey, children }: SheetProps) {
  const sheet = useRef<HTMLElement>(null);
  const id = useId();
  useLayoutEffect(() => {
    const { current } = sheet;
    const before = document.activeElement;
    current?.focus();
    return () => {
      if (current?.contains(document.activeElement) && before instanceof HTMLElement) before.focus();
    };
  }, []);
  return (
    <section ref={sheet} class="sheet" role="dialog" aria-labelledby={id} tabIndex={-1} onKeyDown={onKey}>
      <div class="sheet-head">
        <h2 id={id}>{title}</h2>
        <button type="button" onClick={onClose}>
          {close}
        </button>
      </div>
      {children}
    </section>
  );
}
