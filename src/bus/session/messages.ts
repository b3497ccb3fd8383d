import type { Finding } from '../../diagnosis/index.ts';
import type { Doubt, Refusal } from '../guard.ts';
import type { JobNews, JobOrder } from '../jobs/index.ts';
import type { PortChoice } from '../link/adapters.ts';
import type { InputSignals, LineErrorCounts, LinkSettings, LinkState, OutputSignals } from '../link/link.ts';
import type { LogLine } from '../log/line.ts';
import { knownAt, type TransactionResult, type Unsure, type Verdict } from '../transaction/result.ts';
import type { TransactionRules } from '../transaction/rules.ts';
import type { VirtualNews, VirtualOrder } from '../virtual/bench-messages.ts';
import type { VirtualBusSettings } from '../virtual/virtual-bus.ts';

/** What a window asks of the session, which works in a worker. Plain data. */
export type SessionCommand =
  | { readonly kind: 'open-port'; readonly port: PortChoice; readonly settings: LinkSettings }
  | { readonly kind: 'open-virtual'; readonly settings: LinkSettings; readonly pace: VirtualBusSettings['pace'] }
  | { readonly kind: 'virtual'; readonly order: VirtualOrder }
  /** The virtual devices begin or stop to answer what arrives on the port. Nothing is sent meanwhile. */
  | { readonly kind: 'serve'; readonly on: boolean }
  | { readonly kind: 'close' }
  | { readonly kind: 'set-signals'; readonly signals: OutputSignals }
  | { readonly kind: 'set-rules'; readonly rules: TransactionRules }
  | { readonly kind: 'set-read-only'; readonly readOnly: boolean }
  /** `confirmed`: somebody was asked about this request and said yes; `allowed`: it is sent though only reading is allowed. */
  | {
      readonly kind: 'send';
      readonly id: number;
      readonly request: Uint8Array;
      readonly confirmed: boolean;
      readonly allowed?: true;
    }
  /** Begins a job under a number that the window chooses; a job that has this number already ends. */
  | { readonly kind: 'start-job'; readonly id: number; readonly order: JobOrder; readonly confirmed: boolean }
  | { readonly kind: 'stop-job'; readonly id: number }
  /** Ends everything that is going on. */
  | { readonly kind: 'stop' };

/** What the session tells the window. Plain data. */
export type SessionNews =
  | { readonly kind: 'state'; readonly state: LinkState }
  | { readonly kind: 'signals'; readonly signals: InputSignals | undefined; readonly set: boolean }
  /** In batches, at most some times a second. */
  | { readonly kind: 'lines'; readonly lines: readonly LogLine[] }
  | { readonly kind: 'errors'; readonly errors: LineErrorCounts }
  | { readonly kind: 'result'; readonly id: number; readonly result: SentResult }
  /** Nothing was sent: somebody is to be asked first. */
  | {
      readonly kind: 'ask';
      readonly id: number;
      readonly request: Uint8Array;
      readonly why: Doubt;
      readonly once: boolean;
      readonly allowed?: true;
    }
  | {
      readonly kind: 'ask-job';
      readonly id: number;
      readonly order: JobOrder;
      readonly why: Doubt;
      readonly once: boolean;
    }
  /** What jobs have found, in their order. */
  | { readonly kind: 'jobs'; readonly news: readonly { readonly id: number; readonly news: JobNews }[] }
  | { readonly kind: 'job-ended'; readonly id: number }
  | { readonly kind: 'refused'; readonly id: number; readonly why: Refusal }
  | { readonly kind: 'virtual'; readonly news: VirtualNews }
  | { readonly kind: 'serving'; readonly on: boolean };

/** A transaction that has ended, as data: the meaning is read from the bytes again. */
export interface SentResult {
  readonly request: Uint8Array;
  readonly transport: TransactionResult['transport'];
  readonly outcome: TransactionResult['outcome']['kind'];
  /** What was taken for the reply, whole or broken. */
  readonly reply?: Uint8Array;
  readonly verdict: Verdict;
  /** Milliseconds from the last sending to the reply, or to the end of the time-out. */
  readonly duration: number | undefined;
  readonly attempts: number;
  readonly echo: TransactionResult['echo'];
  readonly unsure?: Unsure;
  /** The last answers of the device came after the time-out; how long the slowest took, in milliseconds. */
  readonly slow?: number;
  /** Why a broken reply is broken, as far as it was found out; the likeliest first. */
  readonly findings: readonly Finding[];
  readonly strays: number;
}

/** A transaction in the form in which the window gets it. */
export function sentResult({
  request,
  transport,
  outcome,
  verdict,
  sentAt,
  endedAt,
  earlier,
  echo,
  unsure,
  slow,
  findings,
  strays,
}: TransactionResult): SentResult {
  return {
    request,
    transport,
    outcome: outcome.kind,
    ...('bytes' in outcome && { reply: outcome.bytes }),
    verdict,
    duration: sentAt === undefined ? undefined : knownAt(outcome, endedAt) - sentAt,
    attempts: earlier.length + (sentAt === undefined ? 0 : 1),
    echo,
    ...(unsure !== undefined && { unsure }),
    ...(slow !== undefined && { slow }),
    findings: outcome.kind === 'broken' ? findings : [],
    strays: strays.length,
  };
}
