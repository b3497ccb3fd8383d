import { computed, type ReadonlySignal, signal } from '@preact/signals-core';
import { bytesSent, type Compared, comparedWith, type Draft, type Evaluation } from '../workbench/index.ts';

/** What a device sent, to be compared with the current frame. It is kept while the page is open. */
export class Comparison {
  /** As typed or pasted. */
  readonly text = signal('');
  /** Empty for a blank text; `undefined` if the text does not say any bytes. */
  readonly bytes: ReadonlySignal<Uint8Array | undefined> = computed(() => bytesSent(this.text.value));

  /** How a frame differs from what was sent; `undefined` while there is nothing to compare. */
  of(draft: Draft, frame: Evaluation['frame']): Compared | undefined {
    const { value: theirs } = this.bytes;
    return frame && theirs && theirs.length > 0 ? comparedWith(theirs, draft, frame) : undefined;
  }
}
