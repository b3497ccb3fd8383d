import type { RefObject } from 'preact';
import { useLayoutEffect } from 'preact/hooks';

/** Measures an element when it is there, and each time its size changes; anew where one of `by` has become another. */
export function useSize<E extends Element>(
  of: RefObject<E | null>,
  measure: (element: E) => void,
  by: readonly unknown[] = [],
): void {
  useLayoutEffect(() => {
    const { current } = of;
    if (!current) return;
    const again = () => measure(current);
    again();
    const observer = new ResizeObserver(again);
    observer.observe(current);
    return () => observer.disconnect();
  }, by);
}
