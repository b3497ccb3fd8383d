import type { Clock } from '../../../src/bus/index.ts';

/** A clock that stands still until it is told to go on. */
export class VirtualClock implements Clock {
  readonly origin = 0;
  #now = 0;
  #order = 0;
  #timers: { due: number; order: number; then: () => void }[] = [];

  now(): number {
    return this.#now;
  }

  after(delay: number, then: () => void): () => void {
    const timer = { due: this.#now + Math.max(0, delay), order: this.#order++, then };
    this.#timers.push(timer);
    return () => {
      this.#timers = this.#timers.filter((other) => other !== timer);
    };
  }

  /** Goes on by so many milliseconds; timers and promises run in between as they are due. */
  async advance(duration: number): Promise<void> {
    const end = this.#now + duration;
    for (;;) {
      await settled();
      const [next] = this.#timers.filter(({ due }) => due <= end).sort((a, b) => a.due - b.due || a.order - b.order);
      if (next === undefined) break;
      this.#timers = this.#timers.filter((other) => other !== next);
      this.#now = Math.max(this.#now, next.due);
      next.then();
    }
    this.#now = end;
    await settled();
  }

  /** Goes on without anything happening, as when a page is held up. */
  holdUp(duration: number): void {
    this.#now += duration;
  }

  /** Goes on until this has come, or fails after so long. */
  async until<T>(promise: Promise<T>, most = 60_000): Promise<T> {
    let done: { value: T } | undefined;
    promise.then((value) => {
      done = { value };
    });
    for (const end = this.#now + most; this.#now < end; ) {
      await settled();
      if (done !== undefined) return done.value;
      const due = Math.min(...this.#timers.map((timer) => timer.due));
      if (due > end) break;
      await this.advance(Math.max(0, due - this.#now));
    }
    throw new Error(`nothing has come in ${most} ms`);
  }
}

/** Promises that are settled have told those who wait for them. */
async function settled(): Promise<void> {
  for (let i = 0; i < 20; i++) await Promise.resolve();
}
