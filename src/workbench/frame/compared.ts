import { type Comparison, compareFrames, type Run } from '../../diagnosis/index.ts';
import { readBytes } from '../../notation/index.ts';
import type { Draft } from './draft.ts';
import { type Evaluation, requestOf } from './evaluate.ts';

/** Two frames, as the parts of the panel show them. */
export interface Compared {
  readonly comparison: Comparison;
  /** The current frame, and what was sent. */
  readonly mine: Uint8Array;
  readonly theirs: Uint8Array;
  /** Whether the current frame is characters. */
  readonly ascii: boolean;
}

/** The bytes of a text in any notation; empty for a blank text, `undefined` if the text does not say any. */
export function bytesSent(text: string): Uint8Array | undefined {
  const { bytes } = readBytes(text);
  return bytes.length === 0 && text.trim() !== '' ? undefined : bytes;
}

/** Compares the frame that a draft comes to with bytes that were sent. */
export function comparedWith(
  theirs: Uint8Array,
  draft: Draft,
  { bytes: mine, reading }: NonNullable<Evaluation['frame']>,
): Compared {
  const { transport, direction } = reading;
  const comparison = compareFrames(mine, theirs, { transport, direction, request: requestOf(draft) });
  return { comparison, mine, theirs, ascii: transport === 'ascii' };
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
