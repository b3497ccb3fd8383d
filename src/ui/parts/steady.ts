import type { ReadonlySignal } from '@preact/signals';
import { useMemo } from 'preact/hooks';
import { steady } from '../../store/index.ts';

/** What `read` makes of signals and of the values in `of`: whoever reads it is drawn again only if it says something else. */
export const useSteady = <T>(read: () => T, of: readonly unknown[] = []): ReadonlySignal<T> =>
  useMemo(() => steady(read), of);
