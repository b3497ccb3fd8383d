import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { readDuration } from '../../../src/notation/index.ts';

describe('a length of time', () => {
  it.each([
    ['5', 5, 'ms'],
    [' 5 ms ', 5, 'ms'],
    ['5MS', 5, 'ms'],
    ['750us', 750, 'us'],
    ['750 µs', 750, 'us'],
    ['750 μs', 750, 'us'],
    ['1.5 s', 1.5, 's'],
    ['1,5 s', 1.5, 's'],
    ['0x10 ms', 16, 'ms'],
    ['10h', 16, 'ms'],
    ['20 bits', 20, 'bits'],
    ['1 bit', 1, 'bits'],
    ['1.5 chars', 1.5, 'characters'],
    ['3.5 characters', 3.5, 'characters'],
    ['0', 0, 'ms'],
  ])('%s', (text, amount, unit) => expect(readDuration(text)).toEqual({ amount, unit }));

  it.each(['', ' ', 'ms', '-1', '−1 ms', '5 m', '5 min', '1,000', '1,000,000', '1..5', 'five', 's5', '5 ms ms'])(
    '“%s” is none',
    (text) => expect(readDuration(text)).toBeUndefined(),
  );

  it('is read or refused whatever is typed', () => {
    fc.assert(
      fc.property(fc.string(), (text) => {
        const read = readDuration(text);
        expect(read === undefined || read.amount >= 0).toBe(true);
      }),
    );
  });
});
