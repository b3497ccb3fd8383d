import { decodeFrame, type SerialMode } from '../../modbus/index.ts';
import type { LinkSettings } from '../link/link.ts';
import type { TransactionResult } from '../transaction/result.ts';

/** The outcome of one request of a scan. */
export interface ScanAnswer {
  /** `broken`: something came that is not a sound reply. */
  readonly outcome: 'reply' | 'exception' | 'broken' | 'silent';
  readonly exceptionCode?: number;
  readonly request: Uint8Array;
  readonly reply?: Uint8Array;
  /** Milliseconds from the request to the reply. */
  readonly duration?: number;
  /** The reply came after the next request was sent: the time-out is too short. */
  readonly late?: true;
}

/** What a scan has found; a finding that is told again replaces the one before. */
export type ScanFinding =
  /** Something has answered at this speed and format. */
  | ({ readonly what: 'unit'; readonly unit: number; readonly settings: LinkSettings } & ScanAnswer)
  /** The port does not open with these settings. */
  | { readonly what: 'not-opened'; readonly settings: LinkSettings }
  | ({ readonly what: 'function'; readonly functionCode: number } & ScanAnswer)
  /**
   * Addresses from first to last that were answered in the same way; neighbouring ranges may be told one after another.
   */
  | ({ readonly what: 'addresses'; readonly first: number; readonly last: number } & ScanAnswer);

/** How far a scan has come. */
export interface ScanNews {
  readonly kind: 'scanned';
  /** How many requests or addresses are done, and how many there are. */
  readonly done: number;
  readonly total: number;
  /** An estimate of the time that is left, in milliseconds. */
  readonly left: number;
  readonly found?: ScanFinding;
}

/** The answer of a transaction; `undefined` if it was not carried out. */
export function answerOf({ outcome, verdict, unsure, request, sentAt }: TransactionResult): ScanAnswer | undefined {
  switch (outcome.kind) {
    case 'reply':
    case 'exception':
    case 'broken': {
      const { bytes: reply, endAt } = outcome;
      const common = { request, reply, ...(sentAt !== undefined && { duration: endAt - sentAt }) };
      // It may be the answer to another request.
      if (unsure !== undefined) return { outcome: 'broken', ...common };
      if (outcome.kind === 'exception') {
        return { outcome: 'exception', exceptionCode: outcome.exceptionCode, ...common };
      }
      return { outcome: outcome.kind === 'broken' || verdict === 'bad' ? 'broken' : 'reply', ...common };
    }
    case 'silent':
      return { outcome: 'silent', request };
    default:
      return undefined;
  }
}

/** The answer in a reply that came after its request was given up. */
export function lateAnswer(request: Uint8Array, reply: Uint8Array, transport: SerialMode): ScanAnswer {
  const exceptionCode = decodeFrame(reply, { transport, direction: 'response', request }).fields['exceptionCode'];
  return {
    ...(typeof exceptionCode === 'number' ? { outcome: 'exception', exceptionCode } : { outcome: 'reply' }),
    request,
    reply,
    late: true,
  };
}
