import type { OtherView } from '../../store/index.ts';
import type { Part } from './slot.tsx';

/** What the shell knows of a view. Its id is its name in the address, and in the words. */
export interface View {
  readonly id: 'frame' | OtherView;
  readonly part: Part<object>;
}
