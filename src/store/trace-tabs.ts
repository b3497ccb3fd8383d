import { type Signal, signal } from '@preact/signals-core';
import type { Tallied, Tally } from '../trace/index.ts';
import type { KnownColumns, TabAnswer, TabTask, Timeline } from '../workbench/index.ts';

/** What was counted, and by what. */
export interface Tallies {
  readonly by: Tallied;
  readonly rows: readonly Tally[];
  /** How many there are in all, of which the rows are the first. */
  readonly count: number;
}

/** What the tabs beside a list show. What holds the trace counts for the tab that is open, and for no other. */
export class TraceTabs {
  readonly timeline: Signal<Timeline | undefined> = signal(undefined);
  readonly tallies: Signal<Tallies | undefined> = signal(undefined);
  readonly known: Signal<KnownColumns | undefined> = signal(undefined);
  /** Whether something else will be shown soon. */
  readonly busy = signal(false);
  readonly #post: (task: TabTask) => void;
  #wanted: TabTask | undefined;
  /** Whether the trace or its list has changed since what is wanted was asked for. */
  #stale = false;

  constructor(post: (task: TabTask) => void) {
    this.#post = post;
  }

  /** What the tab that is open shows from now on; `undefined` if none is open. */
  readonly want = (task: TabTask | undefined): void => {
    this.#wanted = task;
    this.busy.value = false;
    if (task) this.#ask(task);
  };

  /** Asks again if something has changed: the window calls it now and then, so that a trace which grows is not counted all the time. */
  readonly refresh = (): void => {
    if (this.#stale && !this.busy.peek() && this.#wanted) this.#ask(this.#wanted);
  };

  /** The trace has grown, or its list has other rows; `anew` if it is another list, or another trace. */
  changed(anew: boolean): void {
    this.#stale = true;
    if (anew) this.refresh();
  }

  /** Nothing of what was counted holds any more. */
  forget(): void {
    this.timeline.value = undefined;
    this.tallies.value = undefined;
    this.known.value = undefined;
    this.busy.value = false;
    this.#stale = true;
  }

  /** Takes an answer; `list` is the number of the present list. */
  take(answer: TabAnswer, list: number): void {
    switch (answer.kind) {
      case 'timeline':
        if (answer.list === list) this.timeline.value = answer.timeline;
        else this.#stale = true;
        break;
      case 'tallies':
        this.tallies.value = { by: answer.by, rows: answer.tallies, count: answer.count };
        break;
      case 'values':
        this.known.value = answer.known;
        break;
    }
    this.busy.value = false;
    if (answer.kind === 'timeline' && answer.list !== list) this.refresh();
  }

  #ask(task: TabTask): void {
    this.#stale = false;
    this.busy.value = true;
    this.#post(task);
  }
}
