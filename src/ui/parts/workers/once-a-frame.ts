/** Where what is heard waits until the window draws. */
export interface Mail<T> {
  take(one: T): void;
  /** What waits is not heard any more. */
  stop(): void;
}

/**
 * Hands what comes over just before the window draws, all at once and in its order: a window that draws for each message draws what
 * nobody sees. One that is hidden draws nothing, and hears each message as it comes.
 */
export function onceAFrame<T extends object>(take: (one: T) => void): Mail<T> {
  let waiting: T[] = [];
  let frame: number | undefined;
  const hear = () => {
    if (frame !== undefined) cancelAnimationFrame(frame);
    frame = undefined;
    for (let one = waiting.shift(); one !== undefined; one = waiting.shift()) take(one);
  };
  return {
    take(one) {
      waiting.push(one);
      if (document.hidden) hear();
      else frame ??= requestAnimationFrame(hear);
    },
    stop() {
      waiting = [];
    },
  };
}
