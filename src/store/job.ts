import { computed } from '@preact/signals-core';
import type { JobNews, JobOrder, TransactionRules } from '../bus/index.ts';
import type { Bus } from './bus.ts';
import type { JobKind } from './bus-jobs.ts';

/** What carries jobs out, and says how they stand. */
export type JobHost = Pick<Bus, 'job' | 'start' | 'stop' | 'connected'>;

/** A job of this window. It runs on while its panel is not shown. */
export abstract class Job {
  protected readonly host: JobHost;
  readonly #kind: JobKind;
  readonly running = computed(() => this.host.job(this.#kind).value.kind === 'running');
  /** How it ended last; `undefined` while it runs, and before it was first started. */
  readonly end = computed(() => {
    const { value } = this.host.job(this.#kind);
    return value.kind === 'ended' ? value.end : undefined;
  });

  constructor(kind: JobKind, host: JobHost) {
    this.#kind = kind;
    this.host = host;
  }

  readonly stop = (): void => this.host.stop(this.#kind);

  protected begin(order: JobOrder, transport?: TransactionRules['transport']): void {
    this.host.start(order, (all) => this.take(all), transport);
  }

  /** Takes what the job has found since it told last. */
  protected abstract take(news: readonly JobNews[]): void;
}
