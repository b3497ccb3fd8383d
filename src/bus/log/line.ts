import { type SerialMode, toHex } from '../../modbus/index.ts';
import type { Attempt, Outcome, Stray, TransactionResult, Verdict } from '../transaction/result.ts';

/** What stands in a line of the log: a frame or other bytes, and what they were taken for. */
export const lineKinds = [
  'request',
  'reply',
  'exception',
  /** What came in place of a reply, and is no whole frame. */
  'broken',
  'echo',
  'late',
  'other',
  'noise',
  /** What was heard on the line while nothing was asked. */
  'heard',
] as const;
export type LineKind = (typeof lineKinds)[number];

/** One line of the log: bytes that went one way. Plain data, small and cheap to hand from a worker to a window. */
export interface LogLine {
  /** Of this log, counted from 1. */
  readonly number: number;
  /** Milliseconds since 1970. */
  readonly time: number;
  /** Of what is heard while this page listens: `sent` is a request, whoever sent it. */
  readonly direction: 'sent' | 'received';
  readonly transport: SerialMode;
  readonly kind: LineKind;
  /** The bytes as digits, two each. */
  readonly hex: string;
  /** The number of the request that it answers. */
  readonly answers?: number;
  /**
   * Of a request: milliseconds until its reply was there, or it was given up. Of a reply that the virtual devices gave:
   * milliseconds since the request was heard.
   */
  readonly duration?: number;
  /** Of a request: what became of it. Of what is heard while this page listens: what it is by itself. */
  readonly verdict?: Verdict | 'silent';
}

/**
 * The lines of a transaction that has ended, in the order in which they came: each sending of the request, what came in
 * between, and the reply. Nothing was sent, nothing is logged.
 * @param origin what the clock's time counts from, in milliseconds since 1970
 * @param first the number of the first line
 */
export function linesOf(result: TransactionResult, transport: SerialMode, origin: number, first: number): LogLine[] {
  const { request, outcome, sentAt, endedAt, earlier, strays } = result;
  const attempts: readonly Attempt[] = sentAt === undefined ? earlier : [...earlier, { sentAt, endedAt, outcome }];
  const lines: Omit<LogLine, 'number'>[] = [];
  const hex = toHex(request);
  for (const { sentAt, endedAt, outcome } of attempts) {
    const isLast = outcome === result.outcome;
    lines.push({
      time: origin + sentAt,
      direction: 'sent',
      transport,
      kind: 'request',
      hex,
      duration: (timeOf(outcome) ?? endedAt) - sentAt,
      verdict: outcome.kind === 'silent' ? 'silent' : isLast ? result.verdict : 'bad',
    });
    const answer = answerOf(outcome);
    if (answer) lines.push({ time: origin + answer.at, direction: 'received', transport, ...answer.line });
  }
  for (const stray of strays) lines.push(lineOfStray(stray, transport, origin));
  // An echo that is handed over together with the reply came before it.
  lines.sort((one, other) => one.time - other.time || rank(one) - rank(other));
  let asked = 0;
  return lines.map((line, index) => {
    const number = first + index;
    if (line.kind === 'request') asked = number;
    const answers = line.kind === 'reply' || line.kind === 'exception' || line.kind === 'broken';
    return answers && asked > 0 ? { number, ...line, answers: asked } : { number, ...line };
  });
}

const rank = ({ kind }: Pick<LogLine, 'kind'>) => (kind === 'request' ? 0 : kind === 'echo' ? 1 : 2);

const timeOf = (outcome: Outcome) => ('at' in outcome ? outcome.at : undefined);

function answerOf(outcome: Outcome): { at: number; line: Pick<LogLine, 'kind' | 'hex'> } | undefined {
  switch (outcome.kind) {
    case 'reply':
    case 'exception':
    case 'broken':
      return { at: outcome.at, line: { kind: outcome.kind, hex: toHex(outcome.bytes) } };
    default:
      return undefined;
  }
}

const lineOfStray = ({ bytes, at, what }: Stray, transport: SerialMode, origin: number) =>
  ({ time: origin + at, direction: 'received', transport, kind: what, hex: toHex(bytes) }) as const;

/** Lines are kept up to this number; then the oldest go. */
export const MOST_LINES = 100_000;
