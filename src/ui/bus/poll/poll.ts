import { Listeners } from '../../../bus/index.ts';
import type { JobEnd } from '../../../store/index.ts';
import { newPolled, type Polled, type PollSource, withDrawn, withSample } from '../../../workbench/index.ts';
import { bus } from '../index.ts';

export type PollState = { readonly kind: 'idle' | 'running' } | { readonly kind: 'ended'; readonly end: JobEnd };

/** What is shown of a poll. */
export interface ValuesProps {
  readonly polled: Polled;
  /** Changes when there is something new to draw. */
  readonly drawing: number;
  /** What the chart shows, in seconds; 0 is all that is kept. */
  readonly window: number;
  readonly onWindow: (window: number) => void;
}

/** The poll of this window. It runs on while its panel is not shown. */
class Poll {
  readonly #listeners = new Listeners<undefined>();
  state: PollState = { kind: 'idle' };
  polled: Polled | undefined;
  #stop = () => {};

  listen(listener: () => void): () => void {
    return this.#listeners.add(listener);
  }

  start(source: PollSource, interval: number): void {
    this.polled = newPolled(source, interval);
    this.goOn();
  }

  /** Polls the same again, and adds to what was read before. */
  goOn(): void {
    if (this.polled === undefined || this.state.kind === 'running') return;
    const { source, interval } = this.polled;
    this.#set({ kind: 'running' });
    this.#stop = bus.startJob(
      { kind: 'poll', requests: source.requests, interval },
      {
        news: (all) => {
          const isOpen = bus.state.link.kind === 'open';
          for (const news of all)
            if (news.kind === 'sample' && this.polled) this.polled = withSample(this.polled, news, isOpen);
          this.#listeners.tell(undefined);
        },
        ended: (end) => this.#set({ kind: 'ended', end }),
      },
      source.transport,
    );
  }

  stop(): void {
    this.#stop();
  }

  /** Draws a value, or draws it no longer. */
  draw(value: number, drawn: boolean): void {
    if (this.polled === undefined) return;
    this.polled = withDrawn(this.polled, value, drawn);
    this.#listeners.tell(undefined);
  }

  #set(state: PollState): void {
    this.state = state;
    this.#listeners.tell(undefined);
  }
}

export const poll = new Poll();
