/** What went wrong in an exchange, by kind. */
export type FaultKind = (typeof faultKinds)[number];
export const faultKinds = [
  /** The server refused: `data.exception` has the code. */
  'exception',
  'checksum',
  /** No reply within the time-out. */
  'no-reply',
  /** A reply after the time-out. */
  'late',
  /** A reply that may be the one to the request before. */
  'doubtful',
  /** A whole reply that does not answer its request. */
  'mismatch',
  /** Bytes that are not a frame, or a frame that breaks a rule. */
  'broken',
  /** What answers nothing: a reply without a request, a second reply, an echo. */
  'stray',
  /** A silence that is too short for the speed of the line. */
  'timing',
] as const;

/** `code` says more exactly what it is; what else is known stands beside it. `records` are those concerned, by index. */
export interface Fault {
  readonly kind: FaultKind;
  readonly code: string;
  readonly records: readonly number[];
  readonly [data: string]: unknown;
}

/** A request and what came of it, by the indexes of their records. */
export interface Exchange {
  /** Absent if nobody asked for the reply. */
  readonly request?: number | undefined;
  readonly replies: readonly number[];
  /** Microseconds from the request to its first reply, if both have a time. */
  readonly after?: number | undefined;
  readonly faults: readonly Fault[];
}
