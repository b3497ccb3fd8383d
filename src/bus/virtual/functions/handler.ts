import type { ProblemCode, Reading, Values } from '../../../modbus/index.ts';
import type { Device } from '../device.ts';

/** What a device does with a request whose values are legal. */
export type Effect =
  | { readonly kind: 'reply'; readonly fields: Values }
  /** The request again. */
  | { readonly kind: 'echo' }
  | { readonly kind: 'exception'; readonly exceptionCode: number }
  | { readonly kind: 'silence' };

/** How a device carries a function out. Limits and shapes of the fields are the description's, and are checked before. */
export interface Handler {
  /** Whether the device has this kind of it, such as a sub-function; refused with 01 where it does not. */
  readonly knows?: (asked: Reading) => boolean;
  /** Problems that are refused with 02, beside a range beyond the last address; all others are with 03. */
  readonly addressProblems?: readonly ProblemCode[];
  /** It is no event of its own (AP 6.9). */
  readonly uncounted?: boolean;
  perform(device: Device, asked: Reading): Effect;
}

export const ILLEGAL_FUNCTION = 0x01;
export const ILLEGAL_DATA_ADDRESS = 0x02;
export const ILLEGAL_DATA_VALUE = 0x03;

export const ECHO: Effect = { kind: 'echo' };
export const SILENCE: Effect = { kind: 'silence' };
export const reply = (fields: Values): Effect => ({ kind: 'reply', fields });
export const exception = (exceptionCode: number): Effect => ({ kind: 'exception', exceptionCode });
export const noSuchAddress = exception(ILLEGAL_DATA_ADDRESS);
