/** What a frame's bytes tell of why it fails, or that nothing is wrong with it. */
export interface Finding {
  readonly code: string;
  /** The bytes it rests on, `[from, to)`. */
  readonly from: number;
  readonly to: number;
  /** Whole frames that were probably meant, most probable first; empty where nothing can be said. */
  readonly repaired: readonly Uint8Array[];
}
