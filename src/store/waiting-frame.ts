import { firstDraft, type TextStorage } from '../workbench/index.ts';
import type { Page } from './page.ts';

const KEY = 'framewright.waiting-frame';

/** Keeps the frame that waits while a view beside it is open, whose address does not name it, for when the page is loaded again there. */
export class WaitingFrame {
  readonly #page: Pick<Page, 'draft' | 'frameLink' | 'takeFrame'>;
  readonly #texts: () => TextStorage;

  /** @param texts storage of the tab; it is asked each time, and may throw where it is forbidden */
  constructor(page: Pick<Page, 'draft' | 'frameLink' | 'takeFrame'>, texts: () => TextStorage) {
    this.#page = page;
    this.#texts = texts;
  }

  /** Keeps the frame, unless nobody has touched it. */
  readonly keep = (): void => {
    if (this.#page.draft.peek() === firstDraft) return;
    try {
      this.#texts().setItem(KEY, this.#page.frameLink.peek());
    } catch {
      // Where nothing can be kept, the history has it still.
    }
  };

  /** Takes what was kept, once; a frame that is here already stays, and so it does if the page was not loaded `again`. */
  take(again: boolean): void {
    try {
      const link = this.#texts().getItem(KEY);
      this.#texts().removeItem(KEY);
      if (again && link !== null && this.#page.draft.peek() === firstDraft) this.#page.takeFrame(link);
    } catch {
      // As with `keep`.
    }
  }
}
