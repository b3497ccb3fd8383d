import {
  type functionCodes,
  functionOf,
  type ProblemCode,
  type Reading,
  type Values,
  type ValuesOf,
} from '../../../modbus/index.ts';
import type { Device } from '../device.ts';

/** What a device does with a request whose values are legal. */
export type Effect =
  | { readonly kind: 'reply'; readonly fields: Values }
  /** The request again. */
  | { readonly kind: 'echo' }
  | { readonly kind: 'exception'; readonly exceptionCode: number }
  | { readonly kind: 'silence' };

type PublicCode = (typeof functionCodes)[number]['code'];
/** What the request of a function asks: values that have been checked, with the types that its description gives them. */
export type Asked<C extends PublicCode> = ValuesOf<
  Extract<(typeof functionCodes)[number], { readonly code: C }>['request']['fields']
>;

interface HandlerParts {
  /** Whether the device has this variant, such as a sub-function; if not, the request is refused with 01. */
  readonly knows?: (asked: Reading) => boolean;
  /** Problems that are refused with 02, beside a range beyond the last address; all others are with 03. */
  readonly addressProblems?: readonly ProblemCode[];
  /** It does not count as an event (AP 6.9). */
  readonly uncounted?: boolean;
}

/** How a device carries out a function. Limits and shapes of the fields are the description's, and are checked before. */
export interface Handler extends HandlerParts {
  readonly code: number;
  perform(device: Device, asked: Reading): Effect;
}

/** Makes the handler of a function from what a device does with its values. */
export const handle = <C extends PublicCode>(
  code: C,
  perform: (device: Device, asked: Asked<C>, reading: Reading) => Effect,
  parts: HandlerParts = {},
): Handler => ({
  ...parts,
  code: functionOf(code).code,
  // A request with an error never comes here, so that its values are those that the description reads.
  perform: (device, reading) => perform(device, { ...reading.derived, ...reading.fields } as Asked<C>, reading),
});

export const ILLEGAL_FUNCTION = 0x01;
export const ILLEGAL_DATA_ADDRESS = 0x02;
export const ILLEGAL_DATA_VALUE = 0x03;

export const ECHO: Effect = { kind: 'echo' };
export const SILENCE: Effect = { kind: 'silence' };
export const reply = (fields: Values): Effect => ({ kind: 'reply', fields });
export const exception = (exceptionCode: number): Effect => ({ kind: 'exception', exceptionCode });
export const noSuchAddress = exception(ILLEGAL_DATA_ADDRESS);
