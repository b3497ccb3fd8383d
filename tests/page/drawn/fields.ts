import { HTMLFormElement as Form, HTMLSelectElement as Select, type Window } from 'happy-dom';
import { changed } from './locator.ts';
import { oncePerLook } from './look.ts';
import { descendants } from './search.ts';

/** Windows have their classes in common. */
const { requestSubmit } = Form.prototype;
const chosen = Object.getOwnPropertyDescriptor(Select.prototype, 'value');

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
  Object.defineProperty(HTMLSelectElement.prototype, 'value', {
    ...chosen,
    set(value) {
      chosen?.set?.call(this, String(value));
    },
  });
  // Every field asks the whole document for its labels.
  for (const type of [
    HTMLButtonElement,
    HTMLInputElement,
    HTMLMeterElement,
    HTMLOutputElement,
    HTMLProgressElement,
    HTMLSelectElement,
    HTMLTextAreaElement,
  ]) {
    Object.defineProperty(type.prototype, 'labels', { get: labelsOf, configurable: true });
  }
  // A form that may not be sent shows the first field that is wrong.
  HTMLFormElement.prototype.requestSubmit = function (submitter) {
    const wrong: Event[] = [];
    const hear = (event: Event) => wrong.push(event);
    this.addEventListener('invalid', hear, true);
    requestSubmit.call(this as never, submitter as never);
    this.removeEventListener('invalid', hear, true);
    (wrong.find(({ defaultPrevented }) => !defaultPrevented)?.target as HTMLElement | undefined)?.focus();
  };
}

const labelsIn = oncePerLook((document: Document) => {
  const labels = new Map<string | null, Element[]>();
  for (const label of descendants(document, ({ localName }) => localName === 'label')) {
    const id = label.getAttribute('for');
    labels.set(id, [...(labels.get(id) ?? []), label]);
  }
  return labels;
});

/** The labels with the id of an element, and the one that it stands in. */
function labelsOf(this: HTMLElement): Element[] {
  const around = this.closest('label');
  const byId = (this.id !== '' && this.isConnected && labelsIn(this.ownerDocument).get(this.id)) || [];
  return [...new Set([...byId, ...(around ? [around] : [])])];
}
