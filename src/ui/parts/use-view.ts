import { useLayoutEffect, useState } from 'preact/hooks';

/** What the panels of a view are given. */
export interface ViewProps<V> {
  readonly view: V;
}

/** What a view shows: made when the view is opened, and stopped when it is left. Meanwhile the window has the view's title. */
export function useView<V extends { stop(): void }>(title: string, make: () => V): V {
  const [view] = useState(make);
  useLayoutEffect(() => {
    const before = document.title;
    document.title = title;
    return () => {
      view.stop();
      document.title = before;
      // A frame opened far down this view begins at its top.
      scrollTo(0, 0);
    };
  }, [view, title]);
  return view;
}
