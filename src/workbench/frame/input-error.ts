import type { FrameErrorReason } from '../../modbus/index.ts';

/** Why a text makes no value, beside the reasons for which a value makes no bytes. */
export type InputReason =
  | FrameErrorReason
  | { readonly code: 'not-a-number'; readonly text: string }
  | { readonly code: 'not-an-address'; readonly text: string }
  | { readonly code: 'not-a-time'; readonly text: string }
  | { readonly code: 'not-a-bit'; readonly text: string }
  | { readonly code: 'not-octets'; readonly text: string };

/** Why an input has no bytes; `index` names the item of a list. */
export type InputError = InputReason & { readonly index?: number };
