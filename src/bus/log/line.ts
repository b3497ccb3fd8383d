import { type SerialMode, toHex } from '../../modbus/index.ts';
import type { Arrival } from '../transaction/arrivals.ts';
import type { Attempt, TransactionResult, Verdict } from '../transaction/result.ts';

/** What stands in a line of the log: a frame or other bytes, and what they were taken for. */
export const lineKinds = [
  'request',
  'reply',
  'exception',
  /** What came instead of a reply, and is not a valid frame. */
  'broken',
  'echo',
  'late',
  /** A frame that came a short time before, again. */
  'copy',
  'other',
  'noise',
  /** What was heard on the line while nothing was asked. */
  'heard',
] as const;
export type LineKind = (typeof lineKinds)[number];

/** One line of the log: bytes that went one way. Plain data, small and cheap to hand from a worker to a window. */
export interface LogLine {
  /** Milliseconds since 1970. */
  readonly time: number;
  /** Of what is heard while this page listens: `sent` is a request, whoever sent it. */
  readonly direction: 'sent' | 'received';
  readonly transport: SerialMode;
  readonly kind: LineKind;
  /** The bytes as digits, two each. */
  readonly hex: string;
  /**
   * Of a request: what became of it; `absent` is no reply to a request by which a scan asks whether something is there. Of what
   * is heard while this page listens: what it is by itself.
   */
  readonly verdict?: Verdict | 'silent' | 'absent';
}

/**
 * The lines of a transaction that has ended, in the order in which they came: each sending of the request, what came in
 * between, and the reply. Nothing was sent, nothing is logged.
 * @param origin what the clock's time counts from, in milliseconds since 1970
 */
export function linesOf(result: TransactionResult, transport: SerialMode, origin: number): LogLine[] {
  const { request, outcome, sentAt, endedAt, earlier, strays } = result;
  const attempts: readonly Attempt[] = sentAt === undefined ? earlier : [...earlier, { sentAt, endedAt, outcome }];
  const lines: { readonly line: LogLine; readonly place: number }[] = [];
  const hex = toHex(request);
  const receive = ({ bytes, at, place }: Arrival, kind: LineKind) =>
    lines.push({
      line: { time: origin + at, direction: 'received', transport, kind, hex: toHex(bytes) },
      place,
    });
  for (const { sentAt, outcome } of attempts) {
    const isLast = outcome === result.outcome;
    const silent = result.probes ? 'absent' : 'silent';
    const line: LogLine = {
      time: origin + sentAt,
      direction: 'sent',
      transport,
      kind: 'request',
      hex,
      verdict: outcome.kind === 'silent' ? silent : isLast ? result.verdict : isAnswer(outcome) ? 'doubtful' : 'bad',
    };
    lines.push({ line, place: -1 });
    if (isAnswer(outcome) || outcome.kind === 'broken') receive(outcome, outcome.kind);
  }
  for (const stray of strays) receive(stray, stray.what);
  lines.sort((one, other) => one.line.time - other.line.time || one.place - other.place);
  return lines.map(({ line }) => line);
}

const isAnswer = <T extends { readonly kind: string }>(one: T): one is Extract<T, { kind: 'reply' | 'exception' }> =>
  one.kind === 'reply' || one.kind === 'exception';
