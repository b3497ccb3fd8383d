import { itemsOf, type JobNews, Listeners, type PollSample, type Refusal, Samples } from '../../bus/index.ts';
import { heldBy, isNumber, numberOf, type PollSource } from '../../workbench/index.ts';
import { bus, type JobListener } from '../bus/index.ts';

export type PollEnd = 'stopped' | 'lost' | 'disconnected' | 'declined' | Refusal;

export type PollState =
  | { readonly kind: 'idle' }
  | { readonly kind: 'running'; readonly job: number }
  | { readonly kind: 'ended'; readonly why: PollEnd };

/** Values that are drawn until others are chosen, and at most. */
const DRAWN_AT_FIRST = 3;
export const MOST_DRAWN = 8;

/** What has been polled. It grows while the poll runs. */
export interface Polled {
  readonly source: PollSource;
  readonly interval: number;
  readonly samples: Samples;
  /** The registers or bits of each value, from its last reading; `undefined` if that failed. */
  readonly items: (readonly number[] | undefined)[];
  /** The values that are drawn, by their place among all. */
  readonly drawn: readonly number[];
  readonly requests: number;
  readonly failed: number;
}

/** What is shown of it. */
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
  #stopping = false;

  listen(listener: () => void): () => void {
    return this.#listeners.add(listener);
  }

  start(source: PollSource, interval: number): void {
    const numbers = source.values.flatMap((value, index) => (isNumber(value) ? [index] : []));
    this.polled = {
      source,
      interval,
      samples: new Samples(source.values.length),
      items: new Array<undefined>(source.values.length).fill(undefined),
      drawn: numbers.slice(0, DRAWN_AT_FIRST),
      requests: 0,
      failed: 0,
    };
    this.goOn();
  }

  /** Polls the same again, and adds to what was read before. */
  goOn(): void {
    if (this.polled === undefined || this.state.kind === 'running') return;
    const { source, interval } = this.polled;
    if (bus.state.rules.transport !== source.transport) {
      bus.setRules({ ...bus.state.rules, transport: source.transport });
    }
    this.#stopping = false;
    const job = bus.startJob(
      { kind: 'poll', requests: source.requests, interval },
      { news: (all) => this.#take(all), ended: (why) => this.#ended(why) },
    );
    this.#set({ kind: 'running', job });
  }

  stop(): void {
    if (this.state.kind !== 'running') return;
    this.#stopping = true;
    bus.stopJob(this.state.job);
  }

  /** Draws a value, or draws it no longer. */
  draw(value: number, drawn: boolean): void {
    if (this.polled === undefined) return;
    const others = this.polled.drawn.filter((other) => other !== value);
    if (drawn && others.length >= MOST_DRAWN) return;
    this.polled = { ...this.polled, drawn: drawn ? [...others, value].toSorted((a, b) => a - b) : others };
    this.#listeners.tell(undefined);
  }

  #set(state: PollState): void {
    this.state = state;
    this.#listeners.tell(undefined);
  }

  #take(all: readonly JobNews[]): void {
    for (const news of all) if (news.kind === 'sample') this.#add(news);
    this.#listeners.tell(undefined);
  }

  #add({ index, time, outcome, reply }: PollSample): void {
    const { polled } = this;
    if (polled === undefined) return;
    const { source, samples, items } = polled;
    // A round in which nothing could be read is a gap in what is drawn.
    if (index === 0) samples.begin(time);
    if (outcome === 'lost' || outcome === 'cancelled') return;
    if (outcome === 'not-sent' && bus.state.link.kind !== 'open') return;
    const request = source.requests[index];
    const read = source.reads[index];
    if (request === undefined || read === undefined) return;
    const list = reply && itemsOf(read, request, reply, source.transport);
    this.polled = {
      ...polled,
      requests: polled.requests + 1,
      failed: polled.failed + (list === undefined ? 1 : 0),
    };
    for (const [number, value] of source.values.entries()) {
      const { where } = value;
      if (where.read !== index) continue;
      const own = list?.slice(where.at, where.at + where.size);
      const raw = own && heldBy(value, own);
      items[number] = own;
      if (raw === undefined) samples.failed(number);
      else samples.read(number, time, raw, numberOf(raw, value));
    }
  }

  #ended(why: Parameters<JobListener['ended']>[0]): void {
    const { kind } = bus.state.link;
    this.#set({
      kind: 'ended',
      why:
        why === 'refused'
          ? (bus.state.refused ?? 'read-only')
          : why === 'declined'
            ? why
            : kind === 'lost'
              ? 'lost'
              : kind === 'open' || this.#stopping
                ? 'stopped'
                : 'disconnected',
    });
  }
}

export const poll = new Poll();
