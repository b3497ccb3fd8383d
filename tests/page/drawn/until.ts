import { look } from './look.ts';

/** Of Node, because the timers of a page end with it. */
const later = setTimeout;

/** Milliseconds that something may take which is certain to come: a machine with other work to do is no fault of the page. */
export const PATIENCE = 60_000;

/** The longest time between two looks, in milliseconds. */
const LOOK = 50;

/** Waits until something holds, which asking does not change; throws what is said of it if it never does. */
export async function until(holds: () => boolean, said: () => string): Promise<void> {
  const begun = performance.now();
  for (let wait = 0; !look(holds); wait = Math.min(wait + 1, LOOK)) {
    if (performance.now() - begun > PATIENCE) throw new Error(said());
    await new Promise((resolve) => later(resolve, wait));
  }
}
