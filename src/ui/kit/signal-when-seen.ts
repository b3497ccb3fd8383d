import { effect, type ReadonlySignal, useSignal } from '@preact/signals';
import type { RefObject } from 'preact';
import { useLayoutEffect } from 'preact/hooks';

/** Out of sight, this many milliseconds pass before anything is drawn: typing draws what is seen and no more. */
const LATER = 100;

/**
 * A signal that follows another at once while an element is in sight, and else at the next pause or when the element is
 * seen. Where both are the same each time, nothing is drawn until this one changes.
 */
export function useSignalWhenSeen<T>(source: ReadonlySignal<T>, element: RefObject<Element | null>): ReadonlySignal<T> {
  const shown = useSignal(source.peek());
  useLayoutEffect(() => {
    let seen = true;
    let waiting: ReturnType<typeof setTimeout> | undefined;
    const follow = () => {
      shown.value = source.peek();
    };
    const observer = new IntersectionObserver((entries) => {
      seen = entries.some(({ isIntersecting }) => isIntersecting);
      if (seen) follow();
    });
    if (element.current) observer.observe(element.current);
    const stop = effect(() => {
      void source.value;
      clearTimeout(waiting);
      if (seen) follow();
      else waiting = setTimeout(follow, LATER);
    });
    return () => {
      stop();
      clearTimeout(waiting);
      observer.disconnect();
    };
  }, [source]);
  return shown;
}
