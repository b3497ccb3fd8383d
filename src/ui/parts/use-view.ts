import { signal } from '@preact/signals';
import { useLayoutEffect, useState } from 'preact/hooks';

/** What the panels of a view are given. */
export interface ViewProps<V> {
  readonly view: V;
}

/** The title of the view that is open, beside the Frame view. */
export const viewTitle = signal<string | undefined>(undefined);

/** What a view shows: made when the view is opened, and stopped when it is left. Meanwhile the window has the view's title. */
export function useView<V extends { stop(): void }>(title: string, make: () => V): V {
  const [view] = useState(make);
  useLayoutEffect(() => {
    viewTitle.value = title;
    return () => {
      view.stop();
      viewTitle.value = undefined;
    };
  }, [view, title]);
  return view;
}
