import { batch, computed, type Signal, signal } from '@preact/signals-core';
import type { JobNews, Refusal, SequenceEnd, StepOutcome } from '../bus/index.ts';
import { type ListName, placeKey, type Sequence, type SequenceTexts } from '../sequences/index.ts';
import { Job, type JobHost } from './job.ts';

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

type Marks = ReadonlyMap<string, StepMark>;

/** The run of a sequence: how far it is, and what came of its steps. */
export class SequenceRun extends Job {
  /** What was started: marks are of this one, and of no other that it is changed into. */
  readonly of: Signal<SequenceTexts | undefined> = signal(undefined);
  /** The list whose steps are carried out; `undefined` until the first step begins. */
  readonly #list: Signal<ListName | undefined> = signal(undefined);
  readonly #ends: Signal<Partial<Record<ListName, SequenceEnd>>> = signal({});
  readonly #marks: Signal<Marks> = signal(new Map());
  #stopped = false;
  /** By the key of a step's place (`placeKey`). A session that went away does not say what became of its step: it is lost. */
  readonly marks = computed((): Marks => {
    const marks = this.#marks.value;
    if (this.running.value) return marks;
    const lost: StepMark = { kind: 'ended', outcome: { kind: 'lost' } };
    return new Map(Array.from(marks, ([place, mark]) => [place, mark.kind === 'running' ? lost : mark]));
  });
  readonly phase = computed((): RunPhase => {
    const [list, end] = [this.#list.value, this.end.value];
    if (this.running.value) return list === undefined ? { kind: 'asked' } : { kind: 'running', list };
    if (end === undefined) return { kind: 'idle' };
    if (end.kind === 'refused') return { kind: 'not-begun', why: end.why };
    if (end.kind === 'declined') return { kind: 'not-begun', why: 'declined' };
    // A list of which nothing was heard has no line to end on, or has nothing to do.
    const unheard = end.kind === 'stopped' ? undefined : 'lost';
    const { steps = unheard ?? 'done', finally: last = unheard } = this.#ends.value;
    return { kind: 'ended', how: steps, last: this.of.value?.finally.length === 0 ? undefined : last };
  });

  constructor(host: JobHost) {
    super('sequence', host);
  }

  start(sequence: Sequence, of: SequenceTexts): void {
    if (this.running.value) return;
    this.#stopped = false;
    batch(() => {
      this.of.value = of;
      this.#list.value = undefined;
      this.#ends.value = {};
      this.#marks.value = new Map();
      this.begin({ kind: 'sequence', sequence }, sequence.transport);
    });
  }

  /** Ends the steps, so that the finally list comes. That is ended only by `stopLast`: a key is soon pressed twice. */
  readonly stopSteps = (): void => {
    if (this.#list.value !== 'steps' || this.#stopped) return;
    this.#stopped = true;
    this.stop();
  };

  readonly stopLast = (): void => {
    if (this.#list.value !== 'finally') return;
    // The first time a job is stopped is for its steps.
    if (!this.#stopped) this.stop();
    this.#stopped = true;
    this.stop();
  };

  protected take(all: readonly JobNews[]): void {
    const marks = new Map(this.#marks.value);
    for (const news of all) {
      switch (news.kind) {
        case 'step-began': {
          const { list, at } = news.place;
          // When a repetition begins its next round, the marks of the one before go.
          if (at.at(-1) === 0) {
            const around = at.length === 1 ? `${list} ` : `${placeKey({ list, at: at.slice(0, -1) })}.`;
            for (const key of marks.keys()) if (key.startsWith(around)) marks.delete(key);
          }
          marks.set(placeKey(news.place), { kind: 'running', rounds: news.rounds });
          this.#list.value = list;
          break;
        }
        case 'step-ended':
          marks.set(placeKey(news.place), { kind: 'ended', outcome: news.outcome });
          break;
        case 'list-ended':
          this.#ends.value = { ...this.#ends.value, [news.list]: news.how };
          break;
      }
    }
    this.#marks.value = marks;
  }
}
