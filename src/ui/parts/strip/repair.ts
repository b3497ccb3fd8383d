import { identify } from '../../../diagnosis/index.ts';
import { type Draft, draftOf, requestOf } from '../../../workbench/index.ts';
import { step } from '../store.ts';

/** Makes repaired bytes the current frame, as one step. */
export function repair(draft: Draft, bytes: Uint8Array): void {
  const { transport } = draft;
  const request = requestOf(draft);
  const direction = draft.kind === 'request' ? 'request' : 'response';
  const [best] = identify(bytes, { transport, direction, request });
  // A repaired request is the same request: it answers nothing.
  if (best) step({ ...draft, ...draftOf(best.reading, request), bytes: undefined });
}
