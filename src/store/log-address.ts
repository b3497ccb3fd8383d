import { batch, effect, type Signal, signal, untracked } from '@preact/signals-core';
import {
  type How,
  type LogPlace,
  type LogSource,
  type LogTab,
  logParts,
  ownLogs,
  readLogPlace,
  type UntakenPart,
} from '../workbench/index.ts';
import type { Page } from './page.ts';
import { same } from './steady.ts';
import type { NamedFile, TraceView } from './trace-view.ts';
import { addressOf, partsAt, viewAt } from './views.ts';

const isOwn = (source: LogSource | undefined) => ownLogs.find((own) => own === source);

/**
 * The address of the Log view, `#log?log=demo&filter=crc&row=36`: its log, if that is one of the page's own, the filter, the frame
 * that is chosen, and the tab. What the address says of a log that is not open holds for the next one that is opened.
 */
export class LogAddress<F extends NamedFile = NamedFile> {
  readonly source: Signal<LogSource | undefined> = signal(undefined);
  readonly tab: Signal<LogTab> = signal('rows');
  /** Parts of the address that were not taken. */
  readonly untaken: Signal<readonly UntakenPart[]> = signal([]);
  /** What the address says of a log that is not open. */
  readonly waiting: Signal<LogPlace | undefined> = signal(undefined);
  readonly #page: Page;
  readonly #log: TraceView<F>;
  #before: LogPlace | undefined;
  #how: How = 'edit';

  constructor(page: Page, log: TraceView<F>) {
    this.#page = page;
    this.#log = log;
    page.address.given.subscribe(({ hash }) => untracked(() => batch(() => this.#take(hash))));
    effect(() => {
      const { kind } = log.state.value;
      const { value: waiting } = this.waiting;
      if (kind === 'empty') this.source.value = undefined;
      if (kind !== 'open' || waiting === undefined) return;
      untracked(() => {
        this.waiting.value = undefined;
        this.#show(waiting);
      });
    });
    effect(() => {
      const place = this.#place;
      if (place) untracked(() => this.#follow(place));
    });
  }

  /** Opens a file, or a text that was pasted; as a step, Back returns to one of the page's own logs. */
  readonly open = (what: F | string, how: How = 'step'): void =>
    batch(() => {
      this.#how = how;
      this.source.value = typeof what === 'string' ? 'pasted' : 'file';
      this.untaken.value = [];
      if (typeof what === 'string') this.#log.openText(what);
      else this.#log.open(what);
    });

  /** What the address is to say; `undefined` if that is left to the one there is. */
  get #place(): LogPlace | undefined {
    const source = this.source.value;
    if (source === undefined || this.waiting.value) return undefined;
    const { filter, by, record } = this.#log;
    return { source, filter: filter.value, by: by.value, record: record.value, tab: this.tab.value };
  }

  #take(hash: string): void {
    if (viewAt(hash) !== 'log') return;
    const parts = partsAt(hash);
    this.#before = undefined;
    if (parts.size === 0) {
      // The way to the view names nothing, and finds it as it was left.
      this.untaken.value = [];
      const place = this.#place;
      if (place) this.#follow(place);
      return;
    }
    const { place, untaken } = readLogPlace(parts);
    this.untaken.value = untaken;
    this.tab.value = place.tab;
    const isHere = place.source === undefined || place.source === this.source.peek();
    if (isHere && this.#log.state.peek().kind === 'open') {
      this.#show(place);
      return;
    }
    if (isHere && this.#log.state.peek().kind === 'opening') {
      this.waiting.value = place;
      return;
    }
    const own = isOwn(place.source);
    this.waiting.value = place;
    if (own) this.#log.openOwn(own);
    else this.#log.cancel();
    this.source.value = own;
  }

  #show({ filter, by, record }: LogPlace): void {
    const { filter: ownFilter, by: ownBy, record: ownRecord } = this.#log;
    if (same([filter, by, record], [ownFilter.peek(), ownBy.peek(), ownRecord.peek()])) return;
    this.#log.restore(filter, by, record);
  }

  /** Lets the address follow: in place, but a filter that was not typed is a step, and so is another log if Back finds the one before. */
  #follow(place: LogPlace): void {
    const before = this.#before;
    this.#before = place;
    const { address, view } = this.#page;
    if (view.peek() !== 'log' || (before && same(before, place))) return;
    const entry = { hash: addressOf('log', logParts(place)), input: '' };
    const isOther = before !== undefined && before.source !== place.source;
    const isStep = isOther
      ? isOwn(before.source) !== undefined && this.#how === 'step'
      : before !== undefined && before.filter !== place.filter && this.#log.filterHow === 'step';
    if (!isStep) {
      address.later(() => entry, true);
      return;
    }
    address.now();
    address.step([{ kind: 'push', entry }], entry);
  }
}
