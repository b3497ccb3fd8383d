import type { ComponentChildren } from 'preact';
import { useId, useLayoutEffect, useRef, useState } from 'preact/hooks';
import './popover.css';

interface PopoverProps {
  /** What the button shows. */
  readonly summary: ComponentChildren;
  /** Its name, and that of what it opens, if its text says too little. */
  readonly label?: string | undefined;
  readonly class?: string;
  /** What it holds, made when it is opened. */
  readonly children: (close: () => void) => ComponentChildren;
}

/** The least distance from the edges of the window, in pixels. */
const EDGE = 8;

/** What a button opens above the page, beside itself: Escape or a click elsewhere closes it, and the focus goes back to the button. */
export function Popover({ summary, label, class: given = '', children }: PopoverProps) {
  const id = useId();
  const [open, setOpen] = useState(false);
  const button = useRef<HTMLButtonElement>(null);
  const body = useRef<HTMLDivElement>(null);
  const place = () => {
    if (button.current && body.current) placeBelow(button.current, body.current);
  };
  useLayoutEffect(() => {
    if (!open || !body.current) return undefined;
    place();
    // What it holds may come later, and take more room.
    const observer = new ResizeObserver(place);
    observer.observe(body.current);
    return () => observer.disconnect();
  }, [open]);
  return (
    <div class={`popover ${given}`}>
      <button ref={button} type="button" class="opens" aria-label={label} aria-expanded={open} popovertarget={id}>
        {summary}
      </button>
      <div
        ref={body}
        id={id}
        popover="auto"
        role="dialog"
        aria-label={label ?? (typeof summary === 'string' ? summary : undefined)}
        onBeforeToggle={({ newState }) => setOpen(newState === 'open')}
      >
        {open && children(() => body.current?.hidePopover())}
      </div>
    </div>
  );
}

/** Puts a box below a button, within the window; above it where there is more room. */
function placeBelow(button: HTMLElement, box: HTMLElement): void {
  const { left, top, bottom } = button.getBoundingClientRect();
  const { clientWidth, clientHeight } = document.documentElement;
  const { offsetWidth, offsetHeight } = box;
  const above = bottom + offsetHeight > clientHeight && top - offsetHeight > 0;
  box.style.left = `${scrollX + Math.max(EDGE, Math.min(left, clientWidth - offsetWidth - EDGE))}px`;
  box.style.top = `${scrollY + (above ? top - offsetHeight - 2 : bottom + 2)}px`;
}
