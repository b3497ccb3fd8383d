/** Time as the bus knows it, in milliseconds. Tests bring their own. */
export interface Clock {
  /** Counted from any beginning; never goes back. */
  now(): number;
  /** What `now()` counts from, in milliseconds since 1970. */
  readonly origin: number;
  /** Calls `then` once, `delay` milliseconds from now, never at once; answers how to cancel it. */
  after(delay: number, then: () => void): () => void;
}

/**
 * Timers of the browser are a few milliseconds late, so that the rest of a wait is spent in turns of the event loop.
 */
const TURNS = 6;

/** The time of the browser, exact to a fraction of a millisecond: at high speeds the silence between frames is 1.75 ms. */
export function makeClock(): Clock {
  const { port1, port2 } = new MessageChannel();
  const turns: (() => void)[] = [];
  port1.onmessage = () => turns.shift()?.();
  const inTurn = (turn: () => void) => {
    turns.push(turn);
    port2.postMessage(undefined);
  };
  // Nearly all waits are cancelled. The browser's timer of a cancelled wait is left for the next one, which costs less.
  const sleepers = new Map<() => void, number>();
  let alarmAt = Number.POSITIVE_INFINITY;
  let alarm: ReturnType<typeof setTimeout> | undefined;
  const sleep = (until: number, wake: () => void) => {
    sleepers.set(wake, until);
    setAlarm(until);
  };
  const setAlarm = (at: number) => {
    if (at >= alarmAt) return;
    clearTimeout(alarm);
    alarmAt = at;
    alarm = setTimeout(ring, at - performance.now());
  };
  const ring = () => {
    alarmAt = Number.POSITIVE_INFINITY;
    const now = performance.now();
    for (const [wake, until] of [...sleepers].sort(([, one], [, other]) => one - other)) {
      if (until > now) setAlarm(until);
      else if (sleepers.delete(wake)) inTurn(wake);
    }
  };
  return {
    now: () => performance.now(),
    origin: performance.timeOrigin,
    after(delay, then) {
      const due = performance.now() + delay;
      let off = false;
      const wait = () => {
        if (off) return;
        const left = due - performance.now();
        if (left > TURNS) sleep(due - TURNS, wait);
        else if (left > 0) inTurn(wait);
        else then();
      };
      if (delay > TURNS) wait();
      else inTurn(wait);
      return () => {
        off = true;
        sleepers.delete(wait);
      };
    },
  };
}
