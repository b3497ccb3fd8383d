/** What the process is to do. */
export interface Order {
  /** Of each function. */
  readonly calls: number;
  readonly seed: number;
  /** The call of which it says beforehand what it is, or -1. */
  readonly explain: number;
}

/** A line of what the process says: the number of the call that begins, a call in words, or the report at the end. */
export type Said = number | string | Report;

export interface Complaint {
  readonly call: string;
  readonly why: string;
}

export interface Report {
  /** What was called. */
  readonly functions: readonly string[];
  readonly complaints: readonly Complaint[];
}
