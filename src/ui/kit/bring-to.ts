/** What somebody types in: the caret stays there. */
const TYPED_IN =
  'textarea, [contenteditable], input:not([type="checkbox"], [type="radio"], [type="button"], [type="file"])';

/** Of the height of the window: what begins lower is hardly in sight. */
const LOW = 0.6;

/** Brings somebody to an element that has come, with the focus; who is typing stays where they type, and sees it. */
export function bringTo(element: HTMLElement | null): void {
  const { activeElement } = document;
  if (activeElement?.matches(TYPED_IN)) {
    activeElement.scrollIntoView({ block: 'nearest' });
    return;
  }
  if (element === null) return;
  element.focus({ preventScroll: true });
  const { top } = element.getBoundingClientRect();
  if (top < 0 || top > LOW * innerHeight) element.scrollIntoView({ block: 'start' });
}
