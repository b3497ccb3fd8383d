/** A dialect of logs, a row of `tests/vectors/dialects.json`. */
export interface Dialect {
  readonly name: string;
}

/** Bytes of one side: `tx` or `rx`, in what is read also `request`, `response`, or `-` if the dialect leaves it open. */
export interface Entry {
  readonly side: string;
  readonly bytes: Uint8Array;
}

export function writeLog(
  dialect: Dialect,
  entries: readonly Entry[],
): { readonly text: string; readonly chunks: readonly Entry[] };
