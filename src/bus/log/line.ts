import { type SerialMode, toHex } from '../../modbus/index.ts';
import type { Attempt, Outcome, TransactionResult, Verdict } from '../transaction/result.ts';

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
  const lines: Line[] = [];
  const hex = toHex(request);
  for (const { sentAt, endedAt, outcome } of attempts) {
    const isLast = outcome === result.outcome;
    lines.push({
      number: 0,
      time: origin + sentAt,
      direction: 'sent',
      transport,
      kind: 'request',
      hex,
      duration: (timeOf(outcome) ?? endedAt) - sentAt,
      verdict: outcome.kind === 'silent' ? 'silent' : isLast ? result.verdict : 'bad',
    });
    const answer = answerOf(outcome, transport, origin);
    if (answer) lines.push(answer);
  }
  for (const { bytes, at, what } of strays) lines.push(received(bytes, at, what, transport, origin));
  // An echo that is handed over together with the reply came before it.
  lines.sort((one, other) => one.time - other.time || rank(one) - rank(other));
  let asked = 0;
  let number = first;
  for (const line of lines) {
    line.number = number++;
    if (line.kind === 'request') asked = line.number;
    else if (asked > 0 && isAnswer(line)) line.answers = asked;
  }
  return lines;
}

/** A line that has no number yet. */
type Line = { -readonly [K in keyof LogLine]: LogLine[K] };

const isAnswer = ({ kind }: Line) => kind === 'reply' || kind === 'exception' || kind === 'broken';
const rank = ({ kind }: Line) => (kind === 'request' ? 0 : kind === 'echo' ? 1 : 2);

const timeOf = (outcome: Outcome) => ('at' in outcome ? outcome.at : undefined);

function answerOf(outcome: Outcome, transport: SerialMode, origin: number): Line | undefined {
  switch (outcome.kind) {
    case 'reply':
    case 'exception':
    case 'broken':
      return received(outcome.bytes, outcome.at, outcome.kind, transport, origin);
    default:
      return undefined;
  }
}

const received = (bytes: Uint8Array, at: number, kind: LineKind, transport: SerialMode, origin: number): Line => ({
  number: 0,
  time: origin + at,
  direction: 'received',
  transport,
  kind,
  hex: toHex(bytes),
});

/** Lines are kept up to this number; then the oldest go. */
export const MOST_LINES = 100_000;
