import { pasted } from '../../parts/pasted.ts';
import { part, Slot } from '../../parts/slot.tsx';

const list = part(
  ['read'],
  () => import('./frame-list.tsx'),
  ({ FrameList }) => FrameList,
);

/** The place for the list of frames, if the text of the input has more than one. */
export function ListPlace() {
  const state = pasted.state.value;
  return state.kind === 'read' && state.reading.items.length > 1 && <Slot part={list} with={state} />;
}
