import { type Signal, signal } from '@preact/signals-core';
import { type FilterKnown, NOTHING_KNOWN, type TabTask } from '../workbench/index.ts';

/** What occurs in a trace, by which its filter is completed: counted when somebody begins to type, and again if it has grown. */
export class TraceKnown {
  readonly known: Signal<FilterKnown> = signal(NOTHING_KNOWN);
  readonly #post: (task: TabTask) => void;
  #isAsked = false;
  #isStale = true;

  constructor(post: (task: TabTask) => void) {
    this.#post = post;
  }

  /** Somebody is going to want it. */
  readonly want = (): void => {
    if (this.#isAsked || !this.#isStale) return;
    this.#isAsked = true;
    this.#isStale = false;
    this.#post({ kind: 'occurring' });
  };

  /** The trace has grown. */
  changed(): void {
    this.#isStale = true;
  }

  forget(): void {
    this.known.value = NOTHING_KNOWN;
    this.#isAsked = false;
    this.#isStale = true;
  }

  take(known: FilterKnown): void {
    this.#isAsked = false;
    this.known.value = known;
  }
}
