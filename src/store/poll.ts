import { computed, type Signal, signal } from '@preact/signals-core';
import type { JobNews } from '../bus/index.ts';
import {
  defaultPoll,
  newPolled,
  type Polled,
  type PollSettings,
  type PollSource,
  readPollSettings,
  withDrawn,
  withSample,
} from '../workbench/index.ts';
import { Job, type JobHost } from './job.ts';
import { KeptChoice, type PageStorage } from './storage.ts';

/** The poll of this window, and everything that it has read. */
export class Poll extends Job {
  readonly settings: KeptChoice<PollSettings>;
  /** What was read: another object after each reading, whose samples and items are the same. `undefined` before the first poll. */
  readonly polled: Signal<Polled | undefined> = signal(undefined);
  readonly source = computed(() => this.polled.value?.source);
  /** The values that are drawn in the chart, by their place among all. */
  readonly drawn = computed(() => this.polled.value?.drawn ?? this.#none);
  readonly #none: readonly number[] = [];

  constructor(host: JobHost, storage: PageStorage) {
    super('poll', host);
    this.settings = new KeptChoice(storage, 'poll', defaultPoll, readPollSettings);
  }

  start(source: PollSource): void {
    if (this.running.value) return;
    this.polled.value = newPolled(source, this.settings.value.interval);
    this.goOn();
  }

  /** Polls the same again, and adds to what was read before. */
  goOn(): void {
    const polled = this.polled.value;
    if (polled === undefined || this.running.value) return;
    const { source, interval } = polled;
    this.begin({ kind: 'poll', requests: source.requests, interval }, source.transport);
  }

  /** Draws a value in the chart, or no longer. */
  draw(value: number, drawn: boolean): void {
    const polled = this.polled.value;
    if (polled) this.polled.value = withDrawn(polled, value, drawn);
  }

  protected take(all: readonly JobNews[]): void {
    const isOpen = this.host.connected.value;
    this.polled.value = all.reduce(
      (polled, news) => (polled && news.kind === 'sample' ? withSample(polled, news, isOpen) : polled),
      this.polled.value,
    );
  }
}
