import { signal } from '@preact/signals';
import { type After, Commands, Fields, Page, PageStorage } from '../../store/index.ts';
import type { HistoryEntry } from '../../workbench/index.ts';

/** What this page keeps in the browser. */
export const storage = new PageStorage(
  () => localStorage,
  (told) => addEventListener('storage', ({ key }) => told(key)),
);

export const after: After = (milliseconds, act) => {
  const timer = setTimeout(act, milliseconds);
  return () => clearTimeout(timer);
};

/** An entry as the browser takes it. Without a hash the address is the page's own. */
const written = ({ hash, input }: HistoryEntry) =>
  [{ input }, '', hash || location.pathname + location.search] as const;

/** The page with the address of this window. */
export const page = new Page(
  {
    hash: () => location.hash,
    input: () => (history.state as { readonly input?: string } | null)?.input,
    replace: (entry) => history.replaceState(...written(entry)),
    push: (entry) => history.pushState(...written(entry)),
  },
  after,
);

export const commands = new Commands(page, storage);

/** The title of the view that is open, beside the Frame view. */
export const viewTitle = signal<string | undefined>(undefined);

/** The form of the current frame. */
export const fields = new Fields(page);

export const { draft, evaluation, brokenLink, edit, commit, step, show } = page;
