import type { Finding } from '../../diagnosis/index.ts';
import type { Reading, SerialMode } from '../../modbus/index.ts';
import type { LineErrorCounts } from '../link/link.ts';
import type { Arrival } from './arrivals.ts';

const EXCEPTION = 0x80;

/** Bytes that came and are not the reply. */
export interface Stray extends Arrival {
  /**
   * `echo`: the request itself. `late`: the reply to a request that was given up before. `copy`: a frame that came a short
   * time before, again. `other`: another frame, such as the reply of a device that was not asked. `noise`: no frame.
   */
  readonly what: 'echo' | 'late' | 'copy' | 'other' | 'noise';
  /** The request that a late reply answers. */
  readonly answers?: Uint8Array;
}

/** How far a transaction had come when it ended before its end. */
export type Stage = 'queued' | 'sending' | 'waiting';

/** How a request went, in one word. */
export type Verdict =
  /** Answered, or sent and no answer is due. */
  | 'good'
  /** Answered, and something in it is reserved or unsure; the problems, `echo` or `unsure` say what. */
  | 'doubtful'
  /** Refused by an exception. */
  | 'refused'
  /** No reply, a broken one, or one that does not belong to the request. */
  | 'bad'
  /** It was not carried out to its end. */
  | 'ended';

/**
 * Why a reply may be the answer to another request, and so its values those of other registers: `perhaps-late`, a request
 * given up before could be answered by it; `perhaps-copy`, the same came a short time before, and the device has never
 * answered so soon, or this request was answered otherwise before; `two-replies`, another reply that differs came with it.
 */
export type Unsure = 'perhaps-late' | 'perhaps-copy' | 'two-replies';

/** What became of a request that was sent once. Times are the clock's milliseconds. */
export type Outcome =
  /** A whole frame of the unit that was asked. `reading.problems` has what is wrong, also against the request. */
  | ({ readonly kind: 'reply'; readonly reading: Reading } & Arrival)
  | ({ readonly kind: 'exception'; readonly reading: Reading; readonly exceptionCode: number } & Arrival)
  /** A broadcast, or a function without a reply. */
  | { readonly kind: 'sent'; readonly why: 'broadcast' | 'no-reply' }
  /** Nothing came that could be the reply. */
  | { readonly kind: 'silent' }
  /** Bytes came that could be the reply, but are not a whole frame. */
  | ({ readonly kind: 'broken' } & Arrival)
  /** `stuck`: the adapter has not taken the bytes, such as while CTS holds it back. */
  | { readonly kind: 'not-sent'; readonly why: 'not-open' | 'write-failed' | 'stuck' }
  | { readonly kind: 'lost'; readonly stage: Stage }
  | { readonly kind: 'cancelled'; readonly stage: Stage };

/** One sending of a request. */
export interface Attempt {
  readonly sentAt: number;
  readonly endedAt: number;
  readonly outcome: Outcome;
}

/** A transaction that has ended. */
export interface TransactionResult {
  readonly request: Uint8Array;
  readonly transport: SerialMode;
  /** The request as it was read. */
  readonly asked: Reading;
  /** That of the last attempt. */
  readonly outcome: Outcome;
  readonly verdict: Verdict;
  /** When it was asked for; sent the last time (`undefined` if it never was); ended. */
  readonly queuedAt: number;
  readonly sentAt: number | undefined;
  readonly endedAt: number;
  /** Those before the last. */
  readonly earlier: readonly Attempt[];
  readonly strays: readonly Stray[];
  /** `undecided`: the reply is the same as the request, and whether the adapter echoes is not known yet. */
  readonly echo: 'none' | 'removed' | 'undecided';
  /** Why the reply may not be the one to this request; absent if that is sure. */
  readonly unsure?: Unsure;
  /** The request that a reply which is perhaps late may answer, and when it was sent. */
  readonly perhapsTo?: { readonly request: Uint8Array; readonly sentAt: number };
  /** The last answers of the device all came after the time-out; how long the slowest took, in milliseconds. */
  readonly slow?: number;
  /** Errors of the line while it went on. */
  readonly errors: LineErrorCounts;
  /** Why the reply is broken or does not fit; empty if nothing is wrong. */
  readonly findings: readonly Finding[];
  /** Silence is an answer too, as in a scan. */
  readonly probes?: boolean;
}

/** The verdict of an outcome. */
export function verdictOf(
  outcome: Outcome,
  { echo, unsure }: { readonly echo: TransactionResult['echo']; readonly unsure: Unsure | undefined },
): Verdict {
  switch (outcome.kind) {
    case 'reply': {
      const { problems } = outcome.reading;
      if (problems.some(({ severity }) => severity === 'error')) return 'bad';
      const isWarned = problems.some(({ severity }) => severity === 'warning');
      return isWarned || echo === 'undecided' || unsure !== undefined ? 'doubtful' : 'good';
    }
    case 'exception':
      if (outcome.reading.problems.some(({ severity }) => severity === 'error')) return 'bad';
      return unsure === undefined ? 'refused' : 'doubtful';
    case 'sent':
      return 'good';
    case 'silent':
    case 'broken':
      return 'bad';
    default:
      return 'ended';
  }
}

/** What a frame is that was taken for the reply. */
export function answerOf({ bytes, at, endAt, place }: Arrival, reading: Reading): Outcome {
  const arrival = { bytes, at, endAt, place };
  const exceptionCode = reading.fields['exceptionCode'];
  return isException(reading) && typeof exceptionCode === 'number'
    ? { kind: 'exception', ...arrival, reading, exceptionCode }
    : { kind: 'reply', ...arrival, reading };
}

export const isException = ({ functionCode = 0 }: Reading): boolean => (functionCode & EXCEPTION) !== 0;

/** When what an outcome says was known: with the last byte of the reply, or else when it was given up. */
export const knownAt = (outcome: Outcome, endedAt: number): number => ('endAt' in outcome ? outcome.endAt : endedAt);
