import type { Window } from 'happy-dom';
import { changed } from './locator.ts';

/** What browsers do with the fields of a form, and the document of the tests does not. */
export function completeFields(window: Window): void {
  // Who leaves a field, or takes what was typed in it by Enter, has changed it: only the browser knows of both.
  const tell = ({ target }: { target: unknown }) => {
    if (changed.delete(target as Element)) (target as Element).dispatchEvent(new Event('change', { bubbles: true }));
  };
  window.addEventListener('blur', tell, true);
  window.addEventListener('keydown', (event) => {
    const { key, target, defaultPrevented } = event as unknown as KeyboardEvent;
    if (key === 'Enter') tell(event);
    if (key === 'Enter' && !defaultPrevented && (target as Element).localName === 'summary') {
      (target as HTMLElement).click();
    }
  });
  // A value that is a number chooses what its text does.
  const chosen = Object.getOwnPropertyDescriptor(HTMLSelectElement.prototype, 'value');
  Object.defineProperty(HTMLSelectElement.prototype, 'value', {
    ...chosen,
    set(value) {
      chosen?.set?.call(this, String(value));
    },
  });
  // A form that may not be sent shows the first field that is wrong.
  const { requestSubmit } = HTMLFormElement.prototype;
  HTMLFormElement.prototype.requestSubmit = function (submitter) {
    const wrong: Event[] = [];
    const hear = (event: Event) => wrong.push(event);
    this.addEventListener('invalid', hear, true);
    requestSubmit.call(this, submitter);
    this.removeEventListener('invalid', hear, true);
    (wrong.find(({ defaultPrevented }) => !defaultPrevented)?.target as HTMLElement | undefined)?.focus();
  };
}
