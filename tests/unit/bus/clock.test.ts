import { expect, test } from 'vitest';
import { makeClock } from '../../../src/bus/index.ts';

const clock = makeClock();

test('waits end, never too soon and never at once, and not when they were called off', async () => {
  const began = clock.now();
  const came: number[] = [];
  const delays = [40, 8, 25, 3, 0, 60, 25];
  const calledOff = [1, 8, 30].map((delay) => clock.after(delay, () => came.push(-delay)));
  for (const off of calledOff) off();
  const waits = delays.map(
    (delay) =>
      new Promise<void>((resolve) => {
        clock.after(delay, () => {
          expect(clock.now() - began).toBeGreaterThanOrEqual(delay);
          came.push(delay);
          resolve();
        });
      }),
  );
  expect(came).toEqual([]);
  await Promise.all(waits);
  expect([...came].sort((one, other) => one - other)).toEqual([0, 3, 8, 25, 25, 40, 60]);
});

test('a wait that is called off when others are due takes none of them along', async () => {
  let late = false;
  await new Promise<void>((resolve) => {
    const off = clock.after(60, () => {
      late = true;
    });
    clock.after(10, () => {
      off();
      clock.after(80, () => clock.after(20, resolve));
    });
  });
  expect(late).toBe(false);
});
