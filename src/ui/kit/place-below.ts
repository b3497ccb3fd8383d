/** Pixels between a button and what opens below it, and between that and the edge of the window. */
const GAP = 4;

/** Puts what opened beside its button: below it, or above where there is no room. */
export function placeBelow(button: HTMLElement | null, opened: HTMLElement | null): void {
  if (button === null || opened === null) return;
  const from = button.getBoundingClientRect();
  const { offsetWidth: width, offsetHeight: height } = opened;
  const below = from.bottom + GAP;
  const top = below + height > innerHeight - GAP && from.top > height + GAP ? from.top - height - GAP : below;
  opened.style.left = `${Math.max(GAP, Math.min(from.left, innerWidth - width - GAP))}px`;
  opened.style.top = `${Math.max(GAP, Math.min(top, innerHeight - height - GAP))}px`;
}
