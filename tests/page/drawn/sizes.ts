import type { Window } from 'happy-dom';
import { isElementVisible } from './visible.ts';

/** Of every element that is shown: nothing is laid out here. */
const SIZE = { width: 1280, height: 400 };

/** Gives what is shown a size, and what is scrolled its event: a document of the tests has neither. */
export function addSizes(window: Window): void {
  const proto = window.HTMLElement.prototype as unknown as HTMLElement;
  const measured = (side: keyof typeof SIZE) => ({
    configurable: true,
    get(this: HTMLElement) {
      if (this === document.documentElement) return side === 'width' ? innerWidth : innerHeight;
      return isElementVisible(this) ? SIZE[side] : 0;
    },
  });
  Object.defineProperties(proto, {
    clientWidth: measured('width'),
    clientHeight: measured('height'),
    scrollTop: {
      configurable: true,
      get(this: HTMLElement) {
        return scrolled.get(this) ?? 0;
      },
      set(this: HTMLElement, given: number) {
        const to = Math.max(0, given);
        if (to === this.scrollTop) return;
        scrolled.set(this, to);
        requestAnimationFrame(() => this.dispatchEvent(new Event('scroll')));
      },
    },
  });
}

const scrolled = new WeakMap<Element, number>();
