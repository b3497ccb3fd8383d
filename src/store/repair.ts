import { identify } from '../diagnosis/index.ts';
import { formatBytes } from '../notation/index.ts';
import { type Draft, draftOf, requestOf } from '../workbench/index.ts';
import type { Page } from './page.ts';

/**
 * Makes repaired bytes the current frame, as one step. They take the place of a text in the input that had this frame and no
 * other; Back brings back what was pasted.
 */
export function repair(page: Page, draft: Draft, bytes: Uint8Array): void {
  const { transport } = draft;
  const request = requestOf(draft);
  const direction = draft.kind === 'request' ? 'request' : 'response';
  const [best] = identify(bytes, { transport, direction, request });
  if (best === undefined) return;
  const { value: pasted } = page.pasted.state;
  const isOnly = pasted.kind === 'read' && pasted.meaning.kind === 'frames' && pasted.reading.items.length === 1;
  page.commit();
  // A repaired request is the same request: it answers nothing.
  page.edit({ ...draft, ...draftOf(best.reading, request), bytes: undefined });
  if (isOnly) page.pasted.restore(best.transport === 'ascii' ? charactersOf(bytes) : formatBytes(bytes));
  page.commit();
}

const charactersOf = (bytes: Uint8Array): string => String.fromCharCode(...bytes).trim();
