import { computed, type ReadonlySignal, type Signal, signal } from '@preact/signals-core';
import type { JobNews, JobOrder, Refusal } from '../bus/index.ts';

/**
 * Why a job is over, or was not begun. `stopped`: it has ended, by itself or because it was stopped. `lost`: the adapter was
 * lost. `disconnected`: the connection was closed, or the session is gone. `declined`: somebody was asked, and said no.
 */
export type JobEnd =
  | { readonly kind: 'stopped' | 'lost' | 'disconnected' | 'declined' }
  | { readonly kind: 'refused'; readonly why: Refusal };

export type JobKind = JobOrder['kind'];
export type JobState = { readonly kind: 'idle' | 'running' } | { readonly kind: 'ended'; readonly end: JobEnd };
/** Takes what a job has found since it told last. */
export type TakeNews = (news: readonly JobNews[]) => void;

interface RunningJob {
  readonly id: number;
  readonly take: TakeNews;
  /** Somebody has stopped it, so that it does not end because its line was closed. */
  readonly stopped: boolean;
}

/** The jobs that were given to the session: at most one of each kind runs. */
export class BusJobs {
  readonly #states: Readonly<Record<JobKind, Signal<JobState>>> = {
    poll: signal({ kind: 'idle' }),
    read: signal({ kind: 'idle' }),
    scan: signal({ kind: 'idle' }),
    listen: signal({ kind: 'idle' }),
    sequence: signal({ kind: 'idle' }),
    trials: signal({ kind: 'idle' }),
  };
  /** Whether any of them runs. */
  readonly anyRuns = computed(() => Object.values(this.#states).some(({ value }) => value.kind === 'running'));
  readonly #running = new Map<JobKind, RunningJob>();
  /** What begins the jobs that wait for a line, by their numbers. */
  readonly #held = new Map<number, () => void>();

  state(kind: JobKind): ReadonlySignal<JobState> {
    return this.#states[kind];
  }

  runs(kind: JobKind): boolean {
    return this.#running.has(kind);
  }

  begin(kind: JobKind, id: number, take: TakeNews): void {
    this.#running.set(kind, { id, take, stopped: false });
    this.#states[kind].value = { kind: 'running' };
  }

  /** Has a job wait for a line that is being opened. */
  hold(id: number, begin: () => void): void {
    this.#held.set(id, begin);
  }

  /** Begins the jobs that wait, or ends them if there will be no line. */
  release(isOpen: boolean): void {
    for (const [id, begin] of this.#held) {
      if (isOpen) begin();
      else this.end(id, { kind: 'disconnected' });
    }
    this.#held.clear();
  }

  /** Notes that somebody stops the job of a kind. Answers its number; `undefined` if none runs, or if it has not begun. */
  stop(kind: JobKind): number | undefined {
    const job = this.#running.get(kind);
    if (job && this.#held.delete(job.id)) {
      this.end(job.id, { kind: 'stopped' });
      return undefined;
    }
    if (job) this.#running.set(kind, { ...job, stopped: true });
    return job?.id;
  }

  wasStopped(id: number): boolean {
    return [...this.#running.values()].some((job) => job.id === id && job.stopped);
  }

  /** A job is over; nothing if it was before, or if the number is not that of a job. */
  end(id: number, end: JobEnd): void {
    for (const [kind, job] of this.#running) {
      if (job.id !== id) continue;
      this.#running.delete(kind);
      this.#states[kind].value = { kind: 'ended', end };
    }
  }

  endAll(end: JobEnd): void {
    for (const { id } of [...this.#running.values()]) this.end(id, end);
  }

  /** Gives each job its own of what the session tells. */
  take(news: readonly { readonly id: number; readonly news: JobNews }[]): void {
    for (const { id, take } of this.#running.values()) {
      const own = news.filter((one) => one.id === id).map((one) => one.news);
      if (own.length > 0) take(own);
    }
  }
}
