import { type HeardNews, Listeners } from '../../../bus/index.ts';
import type { JobEnd } from '../../../store/index.ts';
import { bus } from '../index.ts';

interface ListeningState {
  readonly running: boolean;
  readonly end: JobEnd | undefined;
  readonly heard: HeardNews | undefined;
}

/** What this window hears. It listens on while its panel is not shown. */
class Listening {
  readonly #listeners = new Listeners<undefined>();
  #stop = () => {};
  state: ListeningState = { running: false, end: undefined, heard: undefined };

  follow(listener: () => void): () => void {
    return this.#listeners.add(listener);
  }

  start(): void {
    this.#set({ running: true, end: undefined, heard: undefined });
    this.#stop = bus.startJob(
      { kind: 'listen' },
      {
        news: (all) => {
          const heard = all.findLast((one) => one.kind === 'heard');
          if (heard) this.#set({ heard });
        },
        ended: (end) => this.#set({ running: false, end }),
      },
    );
  }

  stop(): void {
    this.#stop();
  }

  #set(change: Partial<ListeningState>): void {
    this.state = { ...this.state, ...change };
    this.#listeners.tell(undefined);
  }
}

export const listening = new Listening();
