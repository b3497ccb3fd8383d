import { type Signal, signal } from '@preact/signals-core';
import type { HeardNews, JobNews } from '../bus/index.ts';
import { Job, type JobHost } from './job.ts';

/** What this window hears of what others send. */
export class Listening extends Job {
  readonly heard: Signal<HeardNews | undefined> = signal(undefined);

  constructor(host: JobHost) {
    super('listen', host);
  }

  start(): void {
    if (this.running.value) return;
    this.heard.value = undefined;
    this.begin({ kind: 'listen' });
  }

  protected take(all: readonly JobNews[]): void {
    this.heard.value = all.findLast((news) => news.kind === 'heard') ?? this.heard.value;
  }
}
