import type { Comparison, Run } from '../../diagnosis/index.ts';
import type { Draft } from './draft.ts';
import type { Evaluation } from './evaluate.ts';

export interface CompareProps {
  readonly draft: Draft;
  readonly frame: Evaluation['frame'];
}

/** Two frames, as the parts of the panel show them. */
export interface Compared {
  readonly comparison: Comparison;
  /** The current frame, and what was sent. */
  readonly mine: Uint8Array;
  readonly theirs: Uint8Array;
  /** Whether the current frame is characters. */
  readonly ascii: boolean;
}

/** Two aligned bytes, one of each frame; `undefined` if a frame has no byte there. */
export interface ComparedColumn {
  readonly kind: Run['kind'];
  readonly mine: number | undefined;
  readonly theirs: number | undefined;
}

/** Columns of one field. */
export interface ComparedBlock {
  readonly name: string;
  readonly kind: Run['fieldKind'];
  readonly columns: readonly ComparedColumn[];
}

/** The columns of each field, in pieces of at most `most`. */
export function comparedBlocks(runs: readonly Run[], most: number): readonly ComparedBlock[] {
  const blocks: (ComparedBlock & { readonly columns: ComparedColumn[] })[] = [];
  for (const run of runs) {
    for (const column of columnsOf(run)) {
      const last = blocks.at(-1);
      if (last?.name === run.name && last.columns.length < most) last.columns.push(column);
      else blocks.push({ name: run.name, kind: run.fieldKind, columns: [column] });
    }
  }
  return blocks;
}

function columnsOf({ kind, mineFrom, mineTo, theirsFrom, theirsTo }: Run): ComparedColumn[] {
  const at = (from: number, to: number, index: number) => (from + index < to ? from + index : undefined);
  return Array.from({ length: Math.max(mineTo - mineFrom, theirsTo - theirsFrom) }, (_, index) => ({
    kind,
    mine: at(mineFrom, mineTo, index),
    theirs: at(theirsFrom, theirsTo, index),
  }));
}
