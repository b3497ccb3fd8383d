import type { Window } from 'happy-dom';

/** Popovers, which the document of the tests does not have: opened by their button, closed by Escape and by a press elsewhere. */
export function addPopovers(window: Window): void {
  const { document } = window;
  const proto = window.HTMLElement.prototype as unknown as HTMLElement;
  const tell = (box: Element, type: string, newState: string) => {
    const event = new window.Event(type);
    Object.assign(event, { newState, oldState: newState === 'open' ? 'closed' : 'open' });
    (box as unknown as { dispatchEvent(event: unknown): void }).dispatchEvent(event);
  };
  const before = new WeakMap<HTMLElement, HTMLElement | null>();
  const set = (box: HTMLElement, open: boolean, isPressedAway = false) => {
    if (box.hasAttribute('data-open') === open) return;
    const state = open ? 'open' : 'closed';
    tell(box, 'beforetoggle', state);
    const focused = document.activeElement as unknown as HTMLElement | null;
    box.toggleAttribute('data-open', open);
    queueMicrotask(() => tell(box, 'toggle', state));
    // The focus goes back to where it was, unless it has gone elsewhere.
    if (open) before.set(box, focused);
    else if (!isPressedAway && box.contains(focused)) before.get(box)?.focus();
  };
  proto.showPopover = function () {
    set(this, true);
  };
  proto.hidePopover = function () {
    set(this, false);
  };
  const inner = document.querySelector.bind(document);
  document.querySelector = ((selector: string) => inner(selector.replace(':popover-open', '[data-open]'))) as never;
  const opened = () => [...document.querySelectorAll('[data-open]')] as unknown as HTMLElement[];
  document.addEventListener('click', ({ target }) => {
    const button = (target as unknown as Element | null)?.closest?.('[popovertarget]');
    const box = button && document.getElementById(button.getAttribute('popovertarget') ?? '');
    if (box) set(box as unknown as HTMLElement, !box.hasAttribute('data-open'));
  });
  document.addEventListener('pointerdown', ({ target }) => {
    const button = (target as unknown as Element | null)?.closest?.('[popovertarget]');
    for (const box of opened()) {
      if (!box.contains(target as never) && button?.getAttribute('popovertarget') !== box.id) set(box, false, true);
    }
  });
  document.addEventListener('keydown', (event) => {
    const { key } = event as unknown as KeyboardEvent;
    const last = opened().at(-1);
    if (key === 'Escape' && last) set(last, false);
  });
}
