import type { Comparison } from '../../diagnosis/index.ts';
import type { Draft } from './draft.ts';
import type { Evaluation } from './evaluate.ts';

export interface CompareProps {
  readonly draft: Draft;
  readonly frame: Evaluation['frame'];
}

/** Two frames, as the parts of the panel show them. */
export interface Compared {
  readonly comparison: Comparison;
  /** The frame at hand, and what was sent. */
  readonly mine: Uint8Array;
  readonly theirs: Uint8Array;
  /** Whether the frame at hand is characters. */
  readonly ascii: boolean;
}
