import type { FrameErrorReason } from '../../modbus/index.ts';

/** Why a text makes no value, beside the reasons for which a value makes no bytes. */
export type InputReason =
  | FrameErrorReason
  | { readonly code: 'not-a-number'; readonly text: string }
  /** A value in a unit that no device here gives a scale: one has to be chosen, or said what full scale is. */
  | { readonly code: 'unit-without-device'; readonly text: string; readonly unit: string }
  | { readonly code: 'not-an-address'; readonly text: string }
  | { readonly code: 'not-a-time'; readonly text: string }
  | { readonly code: 'not-a-bit'; readonly text: string }
  | { readonly code: 'not-octets'; readonly text: string };

/** Why an input has no bytes; `index` names the item of a list. */
export type InputError = InputReason & { readonly index?: number };
