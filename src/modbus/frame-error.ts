/** Why an input has no bytes. */
export type FrameErrorReason =
  | { readonly code: 'field-missing' }
  | { readonly code: 'number-out-of-range'; readonly least: number; readonly most: number; readonly got: unknown }
  | { readonly code: 'not-a-flag'; readonly got: unknown }
  | { readonly code: 'not-a-list'; readonly got: unknown }
  | { readonly code: 'not-hex'; readonly got: unknown }
  | { readonly code: 'not-ascii'; readonly got: unknown };

/**
 * Thrown by `encodeFrame` for what has no bytes at all. `field` is the path of the field in the input, for example
 * `registers[3]` or `subRequests[0].fileNumber`; `reason` says what is wrong with it and what is legal.
 */
export class FrameError extends Error {
  override readonly name = 'FrameError';
  readonly field: string;
  readonly reason: FrameErrorReason;

  constructor(field: string, reason: FrameErrorReason) {
    super(describe(field, reason));
    this.field = field;
    this.reason = reason;
  }

  get code(): FrameErrorReason['code'] {
    return this.reason.code;
  }
}

function describe(field: string, reason: FrameErrorReason): string {
  switch (reason.code) {
    case 'field-missing':
      return `${field} is missing`;
    case 'number-out-of-range':
      return `${field}: ${String(reason.got)} is not a whole number from ${reason.least} to ${reason.most}`;
    case 'not-a-flag':
      return `${field}: ${String(reason.got)} is not true, false, 1 or 0`;
    case 'not-a-list':
      return `${field}: ${String(reason.got)} is not a list`;
    case 'not-hex':
      return `${field}: ${String(reason.got)} is not pairs of hexadecimal digits`;
    case 'not-ascii':
      return `${field}: ${String(reason.got)} has a character outside ASCII`;
  }
}
