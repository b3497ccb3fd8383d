import { expect, test } from 'vitest';
import { Pace } from '../../../src/bus/transaction/pace.ts';

const paceOf = (times: readonly number[]) => {
  const pace = new Pace();
  for (const time of times) pace.answered(time);
  return pace;
};

test('times that a browser’s clock does not tell apart prove nothing: a simulator on the same computer is never too quick', () => {
  const pace = paceOf([0.4, 0.3, 0.3, 0.4, 0.5, 0.3, 0.4, 0.3, 0.4]);
  expect([0.3, 0.1, 0].map((after) => pace.isTooSoon(after))).toEqual([false, false, false]);
});

test('a reply that comes a millisecond sooner than any is too soon, if the others were alike', () => {
  const pace = paceOf(Array.from({ length: 9 }, () => 20));
  expect([20, 19.2, 18.9, 2].map((after) => pace.isTooSoon(after))).toEqual([false, false, true, true]);
});
