import type { Draft } from './draft.ts';
import type { Evaluation } from './evaluate.ts';
import type { InputError } from './input-error.ts';

/**
 * Why the frame that is shown is the one before: a field has no value (the first such field), or the input says no bytes, or may
 * mean several things of which none is chosen.
 */
export type StaleReason =
  | { readonly code: 'field'; readonly path: string; readonly error: InputError }
  | { readonly code: 'no-bytes' }
  | { readonly code: 'not-chosen' };

/** The current frame; or the last one that there was, and why it is not current. */
export interface ShownFrame {
  readonly draft: Draft;
  readonly frame: Evaluation['frame'];
  readonly stale: StaleReason | undefined;
}

/** Why a draft has no frame; `undefined` if it has one. */
export function fieldFault({ errors, frame }: Evaluation): StaleReason | undefined {
  const [first] = errors;
  return frame !== undefined || first === undefined ? undefined : { code: 'field', path: first[0], error: first[1] };
}
