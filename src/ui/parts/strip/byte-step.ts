import { withByte } from '../../../workbench/index.ts';
import { draft, evaluation, step } from '../store.ts';

/** Changes a byte of the current frame, as one step. */
export function changeByte(at: number, value: number): void {
  const { frame } = evaluation.peek();
  if (frame) step(withByte(draft.peek(), frame, at, value));
}
