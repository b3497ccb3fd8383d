import type { Finding } from '../../diagnosis/index.ts';
import type { Reading, SerialMode } from '../../modbus/index.ts';
import type { LineErrorCounts } from '../link/link.ts';

/** Bytes that came and are not the reply. */
export interface Stray {
  readonly bytes: Uint8Array;
  /** When they came; of several pieces, the first. */
  readonly at: number;
  /**
   * `echo`: the request itself. `late`: the reply to a request that was given up before. `other`: another frame, such
   * as the reply of a device that was not asked. `noise`: no frame.
   */
  readonly what: 'echo' | 'late' | 'other' | 'noise';
  /** The request that a late reply answers. */
  readonly answers?: Uint8Array;
}

/** How far a transaction had come when it ended before its end. */
export type Stage = 'queued' | 'sending' | 'waiting';

/** How a request went, in one word. */
export type Verdict =
  /** Answered, or sent where no answer comes. */
  | 'good'
  /** Answered, and something in it is reserved or unsure; the problems or `echo` say what. */
  | 'doubtful'
  /** Refused by an exception. */
  | 'refused'
  /** No reply, a broken one, or one that does not belong to the request. */
  | 'bad'
  /** It was not carried out to its end. */
  | 'ended';

/** What became of a request that was sent once. Times are the clock's milliseconds. */
export type Outcome =
  /** A whole frame of the unit that was asked. `reading.problems` has what is wrong, also against the request. */
  | { readonly kind: 'reply'; readonly bytes: Uint8Array; readonly reading: Reading; readonly at: number }
  | {
      readonly kind: 'exception';
      readonly bytes: Uint8Array;
      readonly reading: Reading;
      readonly exceptionCode: number;
      readonly at: number;
    }
  /** A broadcast, or a function without a reply. */
  | { readonly kind: 'sent'; readonly why: 'broadcast' | 'no-reply' }
  /** Nothing came that could be the reply. */
  | { readonly kind: 'silent' }
  /** Bytes came that could be the reply, and are no whole frame. */
  | { readonly kind: 'broken'; readonly bytes: Uint8Array; readonly at: number }
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
  /** Errors of the line while it went on. */
  readonly errors: LineErrorCounts;
  /** Why the reply is broken or does not fit; empty where nothing is wrong. */
  readonly findings: readonly Finding[];
}

/** The verdict of an outcome. */
export function verdictOf(outcome: Outcome, echo: TransactionResult['echo']): Verdict {
  switch (outcome.kind) {
    case 'reply': {
      const { problems } = outcome.reading;
      if (problems.some(({ severity }) => severity === 'error')) return 'bad';
      const unsure = echo === 'undecided' || problems.some(({ severity }) => severity === 'warning');
      return unsure ? 'doubtful' : 'good';
    }
    case 'exception':
      return outcome.reading.problems.some(({ severity }) => severity === 'error') ? 'bad' : 'refused';
    case 'sent':
      return 'good';
    case 'silent':
    case 'broken':
      return 'bad';
    default:
      return 'ended';
  }
}
