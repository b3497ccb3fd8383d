import type { Direction } from '../../modbus/index.ts';

/** A place in a text: UTF-16 offsets, the end exclusive. */
export interface TextRange {
  readonly start: number;
  readonly end: number;
}

/**
 * How a text says its bytes: `hex` digits; `decimal` or `binary` numbers; `escapes` among plain characters; the
 * characters of an `ascii-frame`; a `hexdump` with offsets, or one of 16-bit words with the low byte first,
 * `hexdump-words`, as `od -x` prints it.
 */
export type ByteNotation = 'hex' | 'decimal' | 'binary' | 'escapes' | 'ascii-frame' | 'hexdump' | 'hexdump-words';

/**
 * Why numbers are not taken for bytes: `words` stand around them; they are in a `comment`; the text says them again,
 * `repeated`; they are the `address` of a network card, or the `headers` of a packet of the network.
 */
export type SetAside = 'words' | 'comment' | 'repeated' | 'address' | 'headers';

/** What could not be read, or only in part, with its place. */
export type TextProblem = TextRange &
  (
    | { readonly code: 'nibble-missing' }
    | { readonly code: 'odd-digits'; readonly digits: number }
    | { readonly code: 'value-over-255'; readonly got: number }
    | { readonly code: 'not-a-byte' }
    | { readonly code: 'not-of-base'; readonly base: 2 | 10 | 16 }
    | { readonly code: 'character-unknown' }
    | { readonly code: 'escape-unknown' }
    | { readonly code: 'left-out' }
    /** Numbers that may be bytes and are not taken for them. */
    | { readonly code: 'set-aside'; readonly why: SetAside }
    /** The text says the checksum of the bytes before, as a number; `expected` is the CRC of those bytes (SL 2.5.1.2). */
    | { readonly code: 'checksum-said'; readonly got: number; readonly expected: number }
    | { readonly code: 'no-bytes' }
  );

export type TextProblemCode = TextProblem['code'];

/** What the text around bytes says of them, in its own terms. */
export interface ChunkLabel {
  /** `tx` and `rx` are seen from whoever wrote the log. */
  readonly direction?: Direction | 'tx' | 'rx';
  /** The time stamp as it stands in the text. */
  readonly time?: string;
  readonly transport?: 'rtu' | 'ascii' | 'tcp';
}

/** The bytes `[from, to)`, which the text holds together: a line of a log, an array, a dump. */
export interface Chunk extends ChunkLabel {
  readonly from: number;
  readonly to: number;
  /** How these bytes are written, where that is not how most of the text is. */
  readonly reading?: ByteNotation;
}

/** Another way to read the same text. Its bytes are worked out when they are first asked for. */
export interface AlternativeReading {
  readonly reading: ByteNotation;
  readonly bytes: Uint8Array;
}

/** The bytes that a text says. */
export interface ByteText {
  readonly bytes: Uint8Array;
  /** For each byte its place in the text; in ascending order. A line end that stands for CR LF is the place of both. */
  readonly origin: readonly TextRange[];
  readonly reading: ByteNotation;
  readonly alternatives: readonly AlternativeReading[];
  readonly problems: readonly TextProblem[];
  /** Together they cover every byte once, in order. */
  readonly chunks: readonly Chunk[];
}
