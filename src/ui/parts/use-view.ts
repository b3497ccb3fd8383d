import { useLayoutEffect, useState } from 'preact/hooks';
import { WaitingFrame } from '../../store/index.ts';
import { page, viewTitle } from './store.ts';

/** What the panels of a view are given. */
export interface ViewProps<V> {
  readonly view: V;
}

const waiting = new WaitingFrame(page, () => sessionStorage);
// This comes with the first view beside the frame: where the page was loaded again in it, the frame that waited comes back.
waiting.take(performance.getEntriesByType('navigation').some((entry) => 'type' in entry && entry.type !== 'navigate'));

/** Gives the window the title of a view while that is open; the frame waits meanwhile, also for a page that is loaded again. */
export function useViewTitle(title: string): void {
  useLayoutEffect(() => {
    viewTitle.value = title;
    const watch = new AbortController();
    addEventListener('pagehide', waiting.keep, watch);
    return () => {
      watch.abort();
      viewTitle.value = undefined;
    };
  }, [title]);
}

/** What a view shows: made when the view is opened, and stopped when it is left. Meanwhile the window has the view's title. */
export function useView<V extends { stop(): void }>(title: string, make: () => V): V {
  const [view] = useState(make);
  useLayoutEffect(() => () => view.stop(), [view]);
  useViewTitle(title);
  return view;
}
