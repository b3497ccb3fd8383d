import type { ReadonlySignal } from '@preact/signals';
import { useMemo, useRef } from 'preact/hooks';
import { same, steady } from '../../store/index.ts';

/** What `read` makes of signals and of the values in `of`: whoever reads it is drawn again only if it says something else. */
export const useSteady = <T>(read: () => T, of: readonly unknown[] = []): ReadonlySignal<T> =>
  useMemo(() => steady(read), of);

/** A value of plain data; the earlier one while it says the same, so that what `useMemo` makes of it is kept. */
export function useSame<T>(value: T): T {
  const held = useRef(value);
  if (!same(held.current, value)) held.current = value;
  return held.current;
}
