import { describe, expect, it } from 'vitest';
import { library } from '../../../src/words/en/library.ts';
import { poll } from '../../../src/words/en/poll.ts';
import type { ReadFailure } from '../../../src/workbench/index.ts';

const refused = (exceptionCode: number): ReadFailure => ({ outcome: 'exception', verdict: 'refused', exceptionCode });
const silent: ReadFailure = { outcome: 'silent', verdict: 'bad' };

describe('why a value of a poll could not be read', () => {
  // AP 7: the codes and what they are called.
  it.each([
    [refused(1), 'exception 01, ILLEGAL FUNCTION'],
    [refused(2), 'exception 02, ILLEGAL DATA ADDRESS'],
    [refused(3), 'exception 03, ILLEGAL DATA VALUE'],
    [refused(4), 'exception 04, SERVER DEVICE FAILURE'],
    [refused(6), 'exception 06, SERVER DEVICE BUSY'],
    [refused(11), 'exception 0B, GATEWAY TARGET DEVICE FAILED TO RESPOND'],
    [refused(0x60), 'exception 60'],
    [silent, 'no answer'],
    [{ outcome: 'broken', verdict: 'bad' }, 'the answer is not a valid frame'],
    [{ outcome: 'reply', verdict: 'bad' }, 'answered, but not as it should be'],
    [{ outcome: 'not-sent', verdict: 'ended' }, 'the adapter does not accept it'],
  ] as const)('%o', (failure, text) => {
    expect(poll.failed(failure)).toBe(text);
  });

  it('begins large in the map of a device', () => {
    expect(library.failure(refused(2))).toBe('Exception 02, ILLEGAL DATA ADDRESS');
    expect(library.failure(silent)).toBe('no answer');
  });

  it('is named beside the count of failed requests, with a count of each where there are several', () => {
    const twice = [{ failure: refused(2), count: 2 }];
    expect(poll.progress(20, 20, 2, 0, twice)).toBe(
      '20 rounds. 2 of 20 requests failed (10 %): exception 02, ILLEGAL DATA ADDRESS.',
    );
    expect(poll.progress(20, 20, 3, 0, [...twice, { failure: silent, count: 1 }])).toBe(
      '20 rounds. 3 of 20 requests failed (15 %): exception 02, ILLEGAL DATA ADDRESS × 2; no answer × 1.',
    );
    expect(poll.progress(3, 3, 0, 0, [])).toBe('3 rounds. Every request was answered.');
  });
});
