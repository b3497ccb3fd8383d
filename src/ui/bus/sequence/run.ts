import { type JobNews, Listeners, type Refusal, type SequenceEnd, type StepOutcome } from '../../../bus/index.ts';
import { type ListName, placeKey, type Sequence, type SequenceTexts } from '../../../sequences/index.ts';
import type { JobEnd } from '../../../store/index.ts';
import { commands } from '../../parts/store.ts';
import { bus, type JobFollower } from '../bus.ts';

/** What is known of a step in the run that goes on, or that was the last. */
export type StepMark =
  | { readonly kind: 'running'; readonly rounds: readonly number[] }
  | { readonly kind: 'ended'; readonly outcome: StepOutcome };

export type RunPhase =
  | { readonly kind: 'idle' }
  /** Sent off; perhaps somebody is asked first. */
  | { readonly kind: 'asked' }
  | { readonly kind: 'running'; readonly list: ListName }
  | { readonly kind: 'ended'; readonly how: SequenceEnd; readonly last: SequenceEnd | undefined }
  | { readonly kind: 'not-begun'; readonly why: Refusal | 'declined' };

/** The sequence that runs. It goes on while another view is shown, and Escape stops it there too. */
class Run {
  readonly listeners = new Listeners<undefined>();
  phase: RunPhase = { kind: 'idle' };
  /** What was started: marks are of this one, and of no other that it is changed into. */
  of: SequenceTexts | undefined;
  marks: ReadonlyMap<string, StepMark> = new Map();
  #stopJob = () => {};
  #endOffer = () => {};
  #stopped = false;
  #ends: Partial<Record<ListName, SequenceEnd>> = {};

  get active(): boolean {
    return this.phase.kind === 'asked' || this.phase.kind === 'running';
  }

  start(sequence: Sequence, of: SequenceTexts): void {
    this.of = of;
    this.marks = new Map();
    this.#ends = {};
    this.#stopped = false;
    this.#become({ kind: 'asked' });
    this.#endOffer = commands.offer('stop', () => this.stop());
    addEventListener('beforeunload', this.#leaving);
    this.#stopJob = bus.startJob({ kind: 'sequence', sequence }, this.#follower, sequence.transport);
  }

  /** Ends the steps, so that the finally list comes. That is ended only by `stopLast`: a key is soon pressed twice. */
  readonly stop = (): void => {
    if (this.phase.kind !== 'running' || this.phase.list === 'finally' || this.#stopped) return;
    this.#stopped = true;
    this.#stopJob();
  };

  readonly stopLast = (): void => {
    if (this.phase.kind !== 'running' || this.phase.list === 'steps') return;
    // The first time a job is stopped is for its steps.
    if (!this.#stopped) this.#stopJob();
    this.#stopped = true;
    this.#stopJob();
  };

  readonly #follower: JobFollower = {
    news: (all) => {
      for (const news of all) this.#take(news);
      this.listeners.tell(undefined);
    },
    ended: (end) => {
      this.#endOffer();
      removeEventListener('beforeunload', this.#leaving);
      this.marks = new Map(
        [...this.marks].map(([place, mark]) => [
          place,
          // A session that went away does not say what became of its step.
          mark.kind === 'running' ? { kind: 'ended', outcome: { kind: 'lost' } } : mark,
        ]),
      );
      this.#become(this.#phaseAfter(end));
    },
  };

  #phaseAfter(end: JobEnd): RunPhase {
    if (end.kind === 'refused') return { kind: 'not-begun', why: end.why };
    if (end.kind === 'declined') return { kind: 'not-begun', why: 'declined' };
    // A list of which nothing was heard has no line to end on, or has nothing to do.
    const unheard = end.kind === 'stopped' ? undefined : 'lost';
    const { steps = unheard ?? 'done', finally: last = unheard } = this.#ends;
    return { kind: 'ended', how: steps, last: this.of?.finally.length === 0 ? undefined : last };
  }

  #take(news: JobNews): void {
    switch (news.kind) {
      case 'step-began': {
        const { list, at } = news.place;
        const marks = new Map(this.marks);
        // What a repetition did in the round before is over.
        if (at.at(-1) === 0) {
          const around = at.length === 1 ? `${list} ` : `${placeKey({ list, at: at.slice(0, -1) })}.`;
          for (const key of marks.keys()) if (key.startsWith(around)) marks.delete(key);
        }
        this.marks = marks.set(placeKey(news.place), { kind: 'running', rounds: news.rounds });
        this.phase = { kind: 'running', list };
        break;
      }
      case 'step-ended':
        this.marks = new Map(this.marks).set(placeKey(news.place), { kind: 'ended', outcome: news.outcome });
        break;
      case 'list-ended':
        this.#ends[news.list] = news.how;
        break;
    }
  }

  #become(phase: RunPhase): void {
    this.phase = phase;
    this.listeners.tell(undefined);
  }

  readonly #leaving = (event: BeforeUnloadEvent): void => event.preventDefault();
}

export const run = new Run();
