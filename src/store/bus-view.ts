import { effect, type Signal, signal } from '@preact/signals-core';
import { sameBytes } from '../modbus/index.ts';
import { AddressedView } from './addressed-view.ts';
import type { Bus } from './bus.ts';
import type { Page } from './page.ts';

/** The panels of the Bus view of which one is open. The name of each stands in the address. */
export const busTabs = ['reply', 'frame', 'no-answer', 'poll', 'scan', 'listen', 'sequence', 'virtual'] as const;
export type BusTab = (typeof busTabs)[number];

/** Panels in whose place what came of the next request is shown. */
const givesWay: ReadonlySet<BusTab> = new Set(['reply', 'frame', 'no-answer']);

interface Shown {
  /** The filter of the log. */
  readonly search: string;
  readonly tab: BusTab;
}

/** The Bus view: what its address shows, and what follows the current frame and the reply while it is open. */
export class BusView extends AddressedView<Shown> {
  /** A panel that came by itself, until somebody was brought to it. */
  readonly brought: Signal<BusTab | undefined> = signal(undefined);
  readonly #stopFollowing: readonly (() => void)[];

  constructor(page: Page, bus: Pick<Bus, 'last' | 'question' | 'answer'>) {
    super(
      page,
      'bus',
      (parts) => ({
        search: parts.get('search') ?? '',
        tab: busTabs.find((tab) => tab === parts.get('tab')) ?? 'reply',
      }),
      ({ search, tab }) => ({ tab: tab === 'reply' ? '' : tab, search }),
    );
    const before = bus.last.peek();
    this.#stopFollowing = [
      // Whoever looks at a reply, or at a row of the log, sees the next reply; any other panel stays.
      effect(() => {
        const { value: last } = bus.last;
        const { tab } = this.shown.peek();
        if (last === undefined || last === before || !givesWay.has(tab)) return;
        const next = last.outcome === 'silent' ? 'no-answer' : 'reply';
        if (next === tab) return;
        this.brought.value = next;
        this.open(next);
      }),
      closesQuestions(page, bus),
      () => bus.answer(false),
    ];
  }

  readonly open = (tab: BusTab): void => {
    if (tab !== this.shown.peek().tab) this.change({ tab });
  };

  override stop(): void {
    super.stop();
    for (const stop of this.#stopFollowing) stop();
  }
}

/** A question about a request is closed when another frame is the current one. */
const closesQuestions = (page: Pick<Page, 'evaluation'>, bus: Pick<Bus, 'question' | 'answer'>): (() => void) =>
  effect(() => {
    const command = bus.question.value?.command;
    const bytes = page.evaluation.value.frame?.bytes;
    if (command?.kind === 'send' && !(bytes && sameBytes(bytes, command.request))) bus.answer(false);
  });
