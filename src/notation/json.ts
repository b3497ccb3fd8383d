/** Why a text is not JSON that can be read. `detail` is what the engine says, in its own language. */
export type JsonFault =
  | { readonly code: 'not-json'; readonly detail: string }
  /** `most` is the number of lists and objects inside each other that a text may have. */
  | { readonly code: 'too-deep'; readonly most: number };

export type JsonReading =
  | { readonly kind: 'json'; readonly value: unknown }
  | { readonly kind: 'unreadable'; readonly fault: JsonFault };

const DEEPEST = 100;

/**
 * Reads a file of JSON, with or without a byte order mark. A value that nests too deeply is refused as a whole: an engine
 * reads it, but cannot write it again.
 */
export function readJson(text: string): JsonReading {
  let value: unknown;
  try {
    value = JSON.parse(text.replace(/^\uFEFF/, ''));
  } catch (error) {
    return { kind: 'unreadable', fault: { code: 'not-json', detail: error instanceof Error ? error.message : '' } };
  }
  return nestsWithin(value, DEEPEST)
    ? { kind: 'json', value }
    : { kind: 'unreadable', fault: { code: 'too-deep', most: DEEPEST } };
}

const nestsWithin = (value: unknown, most: number): boolean =>
  typeof value !== 'object' ||
  value === null ||
  (most > 0 && Object.values(value).every((inner) => nestsWithin(inner, most - 1)));
