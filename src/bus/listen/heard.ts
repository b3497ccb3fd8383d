/** Hears what others send; nothing is sent. */
export interface ListenOrder {
  readonly kind: 'listen';
}

/** What was heard of one function of one unit. */
export interface HeardCount {
  readonly unit: number;
  /** Without the exception bit. */
  readonly functionCode: number;
  readonly requests: number;
  /** Replies that are not exceptions. */
  readonly replies: number;
  readonly exceptions: number;
  /** Requests that were followed by another request and not by a reply, without broadcasts. */
  readonly unanswered: number;
  /** Frames that break a rule, by themselves or as the reply to their request. */
  readonly wrong: number;
}

/** Everything that has been heard so far. */
export interface HeardNews {
  readonly kind: 'heard';
  /** In the order of the units, then of the functions. */
  readonly counts: readonly HeardCount[];
  readonly frames: number;
  /** Bytes outside all frames. */
  readonly noise: number;
}
