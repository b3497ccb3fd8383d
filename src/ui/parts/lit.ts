/** Attributes by which elements anywhere on the page say which bytes they stand for. */
const FROM = 'data-from';
const TO = 'data-to';

/** Lights what is lit again, on elements that have been drawn since. */
export let relight = (): void => undefined;

/**
 * Lights the bytes under the pointer or the focus everywhere they stand: in the strip, the explanation and the form. The
 * attribute is set past the views, so that nothing is drawn again for it.
 */
export function linkLights(root: HTMLElement): void {
  let lit: Element | undefined;
  let at = '';
  const place = ({ clientX, clientY }: PointerEvent) => `${clientX} ${clientY}`;
  const follow = (event: Event) => {
    // Where the pointer is on nothing that has bytes, the focus says which are meant.
    const source = linked(event.target) ?? linked(document.activeElement);
    if (source === lit) return;
    lit = source;
    relight();
  };
  relight = () => {
    for (const element of root.querySelectorAll('[data-lit]')) element.removeAttribute('data-lit');
    if (lit === undefined) return;
    const [from, to] = rangeOf(lit);
    for (const element of root.querySelectorAll(`[${FROM}]`)) {
      const [first, end] = rangeOf(element);
      if (first < to && end > from) element.setAttribute('data-lit', '');
    }
  };
  root.addEventListener('pointermove', (event) => {
    at = place(event);
  });
  root.addEventListener('pointerover', (event) => {
    // The page that moves under a pointer at rest, as when the focus scrolls it, is no pointing.
    if (place(event) !== at) follow(event);
    at = place(event);
  });
  root.addEventListener('focusin', follow);
}

const linked = (target: EventTarget | null): Element | undefined =>
  target instanceof Element ? (target.closest(`[${FROM}]`) ?? undefined) : undefined;

const rangeOf = (element: Element): readonly [number, number] => [
  Number(element.getAttribute(FROM)),
  Number(element.getAttribute(TO)),
];
