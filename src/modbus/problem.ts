import type { Span } from './span.ts';

/**
 * *error*: no receiver that follows the specification takes this frame; *warning*: it is against the specification's
 * advice, or reserved; *note*: worth knowing, among it everything the specification leaves open.
 */
export type Severity = 'error' | 'warning' | 'note';

/**
 * Where a rule stands: `AP` Application Protocol V1.1b3, `SL` Serial Line V1.02, `TG` TCP/IP guide V1.0b,
 * `PI` PI-MBUS-300 Rev. J.
 */
export type Section = `${'AP' | 'SL' | 'TG' | 'PI'} ${string}`;

export interface Limits {
  readonly got: number;
  readonly least: number;
  readonly most: number;
}
export interface Contradiction {
  readonly got: number;
  readonly expected: number;
}

/** What each problem says besides its place. The sentence is made elsewhere, from the code and this data. */
export interface ProblemData {
  // The frame as a whole
  /** The bytes end before the frame does: at least `missing` more must come. */
  'frame-short': { readonly missing: number };
  /** `bytes` bytes follow the end of the frame. */
  'frame-extra': { readonly bytes: number };
  /** The frame is closed (checksum, MBAP length, CR LF), yet the function's own fields need `missing` more bytes. */
  'pdu-short': { readonly missing: number };
  /** The frame is closed, yet `bytes` bytes in it belong to no field of the function. */
  'pdu-rest': { readonly bytes: number };
  'pdu-too-long': { readonly got: number; readonly most: number };
  'checksum-wrong': Contradiction & { readonly algorithm: 'crc' | 'lrc' };
  'mbap-length-wrong': Contradiction;
  'mbap-length-out-of-range': Limits;
  'protocol-id-not-zero': { readonly got: number };
  'ascii-start': { readonly got: number | undefined };
  'ascii-end': { readonly got: string };
  'ascii-character': { readonly got: number };
  'ascii-lower-case': { readonly got: number };
  'ascii-odd-digit': { readonly got: number };
  // Unit identifiers
  'unit-reserved': { readonly got: number };
  'unit-unspecified': { readonly got: number };
  'unit-zero-on-tcp': object;
  'broadcast-not-agreed': { readonly functionCode: number };
  'reply-from-broadcast': object;
  // Function codes
  'function-zero': object;
  'function-above-127': { readonly got: number };
  'function-reserved': { readonly got: number; readonly vendor: string | undefined };
  'function-user-defined': { readonly got: number; readonly vendor: string | undefined };
  'function-unassigned': { readonly got: number };
  'function-serial-only': { readonly functionCode: number };
  'mei-type-reserved': { readonly got: number };
  'sub-function-reserved': { readonly got: number };
  'sub-function-without-reply': { readonly got: number };
  'no-reply-in-listen-only': object;
  'exception-undefined': { readonly got: number };
  'exception-pi-only': object;
  // Values
  'quantity-out-of-range': Limits;
  'address-range-over-end': { readonly address: number; readonly quantity: number };
  'value-out-of-range': Limits;
  'value-not-allowed': { readonly got: number; readonly allowed: readonly number[] };
  'coil-value-illegal': { readonly got: number };
  'padding-not-zero': { readonly got: number };
  'data-not-allowed': { readonly got: string; readonly allowed: readonly string[] };
  'data-length': { readonly got: number; readonly expected: number };
  'data-length-odd': { readonly got: number };
  'diagnostics-length-open': { readonly got: number };
  'old-controller-limit': { readonly got: number; readonly limit: number };
  'file-number-high': { readonly got: number };
  'reply-too-long': { readonly got: number; readonly most: number };
  'object-id-reserved': { readonly got: number };
  'next-object-not-zero': { readonly got: number };
  'object-count-differs': Contradiction;
  'server-id-layout-open': object;
  // Lengths and counts
  'count-out-of-range': Limits;
  'count-odd': { readonly got: number };
  /** A count contradicts the field it counts for. */
  'count-contradicts-quantity': Contradiction & { readonly quantity: number };
  /** A count contradicts the bytes that are there. */
  'count-wrong': Contradiction;
  'count-table-differs': { readonly got: number; readonly least: number; readonly most: number };
  // Against the request it answers
  'unit-not-as-requested': Contradiction;
  'transaction-not-as-requested': Contradiction;
  'function-not-as-requested': Contradiction;
  'count-not-as-requested': Contradiction;
  'echo-differs': { readonly field: string };
  'broadcast-answered': object;
}

export type ProblemCode = keyof ProblemData;

/** A broken rule without its place, as a field's rule states it; `section` is by default that of the function. */
export type Fault = {
  [C in ProblemCode]: { readonly code: C; readonly severity: Severity; readonly section?: Section } & ProblemData[C];
}[ProblemCode];

/** A broken rule of one frame: what, how bad, by which section, and on which bytes. */
export type Problem = Fault & { readonly section: Section; readonly span: Span };
