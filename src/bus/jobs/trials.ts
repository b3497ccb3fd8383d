import type { SerialMode } from '../../modbus/index.ts';
import type { TransactionResult } from '../transaction/result.ts';
import type { TransactionRules } from '../transaction/rules.ts';
import type { JobParts, RunningJob } from './job.ts';

/** A request, and what of the rules is tried with it. */
export interface Trial {
  readonly request: Uint8Array;
  readonly rules: Partial<Pick<TransactionRules, 'gap' | 'timeout' | 'echo'>>;
}

/** Requests that are sent once each, until one of them is answered. */
export interface TrialOrder {
  readonly kind: 'trials';
  readonly transport: SerialMode;
  readonly trials: readonly Trial[];
}

/** What a trial came to. */
export interface TrialNews {
  readonly kind: 'tried';
  /** The place of the trial in the order. */
  readonly index: number;
  readonly outcome: TransactionResult['outcome']['kind'];
  readonly exceptionCode?: number;
  /** Whether the request itself came back. */
  readonly returned: boolean;
}

/** Sends the requests in their order; one that is answered is the last. */
export function startTrials(
  { transport, trials }: TrialOrder,
  { client, tell }: Pick<JobParts<TrialNews>, 'client' | 'tell'>,
): RunningJob {
  let stopped = false;
  const work = async () => {
    for (const [index, { request, rules }] of trials.entries()) {
      if (stopped) return;
      const result = await client.transact(request, { ...rules, transport, retries: 0 }).result;
      const { outcome } = result;
      const { kind } = outcome;
      tell({
        kind: 'tried',
        index,
        outcome: kind,
        ...(kind === 'exception' && { exceptionCode: outcome.exceptionCode }),
        returned: hasReturned(result),
      });
      if (kind !== 'silent' && kind !== 'broken') return;
    }
  };
  return {
    stop() {
      stopped = true;
    },
    ended: work(),
  };
}

/** Whether the request came back, alone or at the beginning of what was taken for the reply. */
function hasReturned({ echo, outcome, strays, request }: TransactionResult): boolean {
  const begins = (bytes: Uint8Array) => request.every((byte, index) => bytes[index] === byte);
  return echo !== 'none' || strays.some(({ bytes }) => begins(bytes)) || ('bytes' in outcome && begins(outcome.bytes));
}
