import { knownAt, type TransactionResult, type Unsure, type Verdict } from '../transaction/result.ts';
import type { JobParts, RunningJob } from './job.ts';

/** Requests that are sent again and again. */
export interface PollOrder {
  readonly kind: 'poll';
  readonly requests: readonly Uint8Array[];
  /** From the beginning of one round to the beginning of the next, in milliseconds; 0 is as fast as the line goes. */
  readonly interval: number;
}

/** What one request of a round came to. */
export interface PollSample {
  readonly kind: 'sample';
  /** The place of the request in the order. */
  readonly index: number;
  /** Counted from 0. */
  readonly round: number;
  /** When the reply had come or the request was given up: milliseconds since 1970. */
  readonly time: number;
  readonly outcome: TransactionResult['outcome']['kind'];
  readonly verdict: Verdict;
  readonly exceptionCode?: number;
  /** Why the reply may be the answer to another request: its values do not count. */
  readonly unsure?: Unsure;
  /** The last answers of the device came after the time-out; how long the slowest took, in milliseconds. */
  readonly slow?: number;
  /** The reply or exception. */
  readonly reply?: Uint8Array;
  /** Milliseconds from the request to the end of the reply. */
  readonly duration?: number;
}

/** Sends requests in rounds. A round that takes longer than the interval is followed by the next at once. */
export function startPoll(
  { requests, interval }: PollOrder,
  { client, clock, tell }: Pick<JobParts<PollSample>, 'client' | 'clock' | 'tell'>,
): RunningJob {
  let stopped = false;
  let wake = () => {};
  const pause = (delay: number) =>
    new Promise<void>((resolve) => {
      const off = clock.after(delay, resolve);
      wake = () => {
        off();
        resolve();
      };
    });

  const work = async () => {
    for (let round = 0; !stopped; round++) {
      const began = clock.now();
      for (const [index, request] of requests.entries()) {
        if (stopped) return;
        const result = await client.transact(request).result;
        tell({ kind: 'sample', index, round, ...sampleOf(result, clock.origin) });
        // Without a line, polling ends.
        if (result.outcome.kind === 'lost' || result.outcome.kind === 'cancelled') return;
        if (result.outcome.kind === 'not-sent' && result.outcome.why === 'not-open') return;
      }
      const left = began + interval - clock.now();
      if (left > 0 && !stopped) await pause(left);
    }
  };
  return {
    stop() {
      stopped = true;
      wake();
    },
    ended: work(),
  };
}

function sampleOf({ outcome, verdict, unsure, slow, sentAt, endedAt }: TransactionResult, origin: number) {
  const end = knownAt(outcome, endedAt);
  return {
    time: origin + end,
    outcome: outcome.kind,
    verdict,
    ...(outcome.kind === 'exception' && { exceptionCode: outcome.exceptionCode }),
    ...(unsure !== undefined && { unsure }),
    ...(slow !== undefined && { slow }),
    ...('bytes' in outcome && { reply: outcome.bytes }),
    ...(sentAt !== undefined && { duration: end - sentAt }),
  };
}
