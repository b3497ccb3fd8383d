import { type After, Commands, Fields, Page, PageStorage } from '../../store/index.ts';

/** What this page keeps in the browser. */
export const storage = new PageStorage(
  () => localStorage,
  (told) => addEventListener('storage', ({ key }) => told(key)),
);

export const after: After = (milliseconds, act) => {
  const timer = setTimeout(act, milliseconds);
  return () => clearTimeout(timer);
};

/** The page with the address of this window. */
export const page = new Page(
  {
    hash: () => location.hash,
    // Without a hash the address is the page's own.
    replace: (hash) => history.replaceState(null, '', hash || location.pathname + location.search),
    push: (hash) => history.pushState(null, '', hash || location.pathname + location.search),
  },
  after,
);

export const commands = new Commands(page, storage);

/** The form of the current frame. */
export const fields = new Fields(page);

export const { draft, evaluation, brokenLink, edit, commit, step, show } = page;
