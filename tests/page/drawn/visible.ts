import { getAriaDisabled } from 'ivya/utils';
import { isInert } from './dialogs.ts';
import { oncePerLook } from './look.ts';

/** What the page's own styles hide in a window of any size: they are not read here. */
const HIDDEN_BY_STYLE =
  '.in-place[data-said] > span:first-child, .in-place:not([data-said]) > span:last-child, .strip-actions .waiting, .print-sheet';

/** The classes of which these styles speak, of an element or of what it stands in. */
const STYLED = /\b(in-place|waiting|print-sheet)\b/;

/** Whether an element is hidden by what it says of itself. */
export const isHiddenItself = oncePerLook((element: Element): boolean => {
  if (element.hasAttribute('hidden')) return true;
  if (element.hasAttribute('popover') && !element.hasAttribute('data-open')) return true;
  if (element.localName === 'dialog' && !element.hasAttribute('open')) return true;
  const parent = element.parentElement;
  const isStyled = STYLED.test(`${element.className} ${parent?.className}`);
  if (isStyled && element.matches(HIDDEN_BY_STYLE)) return true;
  if (parent?.localName === 'details' && !parent.hasAttribute('open') && element.localName !== 'summary') return true;
  const { display, visibility } = (element as HTMLElement).style ?? {};
  return display === 'none' || visibility === 'hidden';
});

/** Whether an element is shown, as far as that is known without its place in the window. */
export function isElementVisible(element: Element): boolean {
  return element.isConnected && isShown(element);
}

const isShown: (element: Element) => boolean = oncePerLook(
  (element) => !isHiddenItself(element) && (!element.parentElement || isShown(element.parentElement)),
);

/** Whether an element, or the control that it labels, can be reached and used. */
export const isUsable = (element: Element): boolean => {
  if (isInert(element)) return false;
  const isControl = element.matches('button, input, select, textarea');
  return !getAriaDisabled((isControl ? null : element.closest('label')?.control) ?? element);
};
