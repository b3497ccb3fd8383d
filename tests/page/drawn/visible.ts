import { getAriaDisabled } from 'ivya/utils';

/** What the page's own styles hide in a window of any size: they are not read here. */
const HIDDEN_BY_STYLE =
  '.in-place[data-said] > span:first-child, .in-place:not([data-said]) > span:last-child, .strip-actions .waiting, .print-sheet';

/** Whether an element is hidden by what it says of itself. */
export function isHiddenItself(element: Element): boolean {
  if (element.hasAttribute('hidden')) return true;
  if (element.hasAttribute('popover') && !element.hasAttribute('data-open')) return true;
  if (element.localName === 'dialog' && !element.hasAttribute('open')) return true;
  if (element.matches(HIDDEN_BY_STYLE)) return true;
  const parent = element.parentElement;
  if (parent?.localName === 'details' && !parent.hasAttribute('open') && element.localName !== 'summary') return true;
  const { display, visibility } = (element as HTMLElement).style ?? {};
  return display === 'none' || visibility === 'hidden';
}

/** Whether an element is shown, as far as that is known without its place in the window. */
export function isElementVisible(element: Element): boolean {
  if (!element.isConnected) return false;
  for (let at: Element | null = element; at; at = at.parentElement) if (isHiddenItself(at)) return false;
  return true;
}

/** Whether an element, or the control that it labels, can be used. */
export const isUsable = (element: Element): boolean => {
  const isControl = element.matches('button, input, select, textarea');
  return !getAriaDisabled((isControl ? null : element.closest('label')?.control) ?? element);
};
