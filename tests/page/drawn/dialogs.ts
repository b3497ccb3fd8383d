import { HTMLDialogElement as Dialog } from 'happy-dom';

/** Windows have their classes in common. */
const { close } = Dialog.prototype;

/** Fields and buttons that the Tab key comes to. */
const FOCUSABLE = 'button:not([disabled]), input:not([disabled]), select, textarea, a[href], [tabindex="0"]';

/** Those that are open, and what had the focus before each. */
const opened = new Map<HTMLDialogElement, Element | null>();

/** Whether nobody can reach an element: another dialog is open, or it is part of what is inert. */
export function isInert(element: Element): boolean {
  const last = [...opened.keys()].findLast(({ isConnected, open }) => isConnected && open);
  return element.closest('[inert]') !== null || (last !== undefined && !last.contains(element));
}

/** Modal dialogs as browsers have them: they take the focus, give it back, and close by Escape unless the page forbids it. */
export function addDialogs(): void {
  const { prototype } = HTMLDialogElement;
  opened.clear();
  prototype.showModal = function () {
    if (this.open) throw new DOMException('The dialog is open', 'InvalidStateError');
    opened.set(this, document.activeElement);
    this.open = true;
    (this.querySelector<HTMLElement>('[autofocus]') ?? this.querySelector<HTMLElement>(FOCUSABLE))?.focus();
  };
  prototype.close = function (result) {
    const before = opened.get(this);
    opened.delete(this);
    close.call(this as never, result);
    (before as HTMLElement | undefined)?.focus();
  };
  window.addEventListener('keydown', (event) => {
    const last = [...opened.keys()].at(-1);
    if (event.key !== 'Escape' || event.defaultPrevented || !last) return;
    if (last.dispatchEvent(new Event('cancel', { cancelable: true }))) last.close();
  });
}
