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
  /** Exceptions are none. */
  readonly replies: number;
  readonly exceptions: number;
  /** Requests that another request followed, and no reply; broadcasts have none. */
  readonly unanswered: number;
  /** Frames that break a rule, by themselves or against their request. */
  readonly wrong: number;
}

/** All that was heard so far. */
export interface HeardNews {
  readonly kind: 'heard';
  /** In the order of the units, then of the functions. */
  readonly counts: readonly HeardCount[];
  readonly frames: number;
  /** Bytes that are in no frame. */
  readonly noise: number;
}
