import { formatBytes } from '../../../notation/index.ts';
import { words as pageWords } from '../../parts/page-words.ts';
import { draft, evaluation } from '../../parts/store.ts';

/** The current frame, which is what is polled. */
export function FrameChoice() {
  const { frame } = evaluation.value;
  if (frame === undefined) return null;
  return (
    <>
      <p>{pageWords.page.summary(frame.reading, frame.bytes.length, draft.value.transport)}</p>
      <p class="mono bytes-line">{formatBytes(frame.bytes)}</p>
    </>
  );
}
