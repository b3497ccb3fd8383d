import { type Signal, signal } from '@preact/signals-core';
import { addFinding, type JobNews, type ScanFinding, type ScanNews, type ScanOrder } from '../bus/index.ts';
import { defaultScan, readScanSettings, type ScanSettings } from '../workbench/index.ts';
import { Job, type JobHost } from './job.ts';
import { KeptChoice, type PageStorage } from './storage.ts';

/** The scan of this window, and what it has found. */
export class Scan extends Job {
  readonly settings: KeptChoice<ScanSettings>;
  /** What is scanned, or was scanned last. */
  readonly order: Signal<ScanOrder | undefined> = signal(undefined);
  readonly progress: Signal<ScanNews | undefined> = signal(undefined);
  readonly found: Signal<readonly ScanFinding[]> = signal([]);

  constructor(host: JobHost, storage: PageStorage) {
    super('scan', host);
    this.settings = new KeptChoice(storage, 'scan', defaultScan, readScanSettings);
  }

  start(order: ScanOrder): void {
    if (this.running.value) return;
    this.order.value = order;
    this.progress.value = undefined;
    this.found.value = [];
    this.begin(order, order.transport);
  }

  protected take(all: readonly JobNews[]): void {
    const found = [...this.found.value];
    for (const news of all) {
      if (news.kind !== 'scanned') continue;
      this.progress.value = news;
      if (news.found) addFinding(found, news.found);
    }
    if (all.some((news) => news.kind === 'scanned' && news.found)) this.found.value = found;
  }
}
