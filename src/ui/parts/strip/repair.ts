import { identify } from '../../../diagnosis/index.ts';
import { type Draft, requestOf } from '../../../workbench/index.ts';
import { page } from '../store.ts';

/** Makes repaired bytes the current frame, as one step. */
export function repair(draft: Draft, bytes: Uint8Array): void {
  const { transport } = draft;
  const request = requestOf(draft);
  const direction = draft.kind === 'request' ? 'request' : 'response';
  const [best] = identify(bytes, { transport, direction, request });
  if (best) page.showReading(best.reading, request, 'step');
}
