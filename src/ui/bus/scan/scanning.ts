import {
  addFinding,
  type JobNews,
  Listeners,
  type ScanFinding,
  type ScanNews,
  type ScanOrder,
} from '../../../bus/index.ts';
import type { JobEnd } from '../../../store/index.ts';
import { bus } from '../index.ts';

interface ScanState {
  readonly running: boolean;
  readonly order: ScanOrder | undefined;
  readonly end: JobEnd | undefined;
  readonly progress: Omit<ScanNews, 'found'> | undefined;
  readonly found: readonly ScanFinding[];
}

/** The scan of this window. It runs on while its panel is not shown. */
class Scanning {
  readonly #listeners = new Listeners<undefined>();
  #stop = () => {};
  state: ScanState = { running: false, order: undefined, end: undefined, progress: undefined, found: [] };

  follow(listener: () => void): () => void {
    return this.#listeners.add(listener);
  }

  start(order: ScanOrder): void {
    this.#set({ running: true, order, end: undefined, progress: undefined, found: [] });
    this.#stop = bus.startJob(
      order,
      { news: (all) => this.#take(all), ended: (end) => this.#set({ running: false, end }) },
      order.transport,
    );
  }

  stop(): void {
    this.#stop();
  }

  #take(all: readonly JobNews[]): void {
    const found = [...this.state.found];
    let { progress } = this.state;
    for (const news of all) {
      if (news.kind !== 'scanned') continue;
      progress = news;
      if (news.found) addFinding(found, news.found);
    }
    this.#set({ progress, found });
  }

  #set(change: Partial<ScanState>): void {
    this.state = { ...this.state, ...change };
    this.#listeners.tell(undefined);
  }
}

export const scanning = new Scanning();
