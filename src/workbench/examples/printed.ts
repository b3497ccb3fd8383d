import { fromHex } from '../../modbus/index.ts';
import { evaluate } from '../frame/evaluate.ts';
import type { Example } from './examples.ts';

/** A run of bytes that are all as they should be, or all wrong. */
export interface PrintedRun {
  readonly bytes: Uint8Array;
  readonly wrong: boolean;
}

/** The right bytes of an example beside those its source prints. */
export interface PrintedComparison {
  readonly right: Uint8Array;
  readonly printed: Uint8Array;
  /** The printed bytes in order. */
  readonly runs: readonly PrintedRun[];
  /** Where the printed bytes are wrong. */
  readonly wrongAt: readonly number[];
}

const none = new Uint8Array();

export function comparePrinted({ draft, printed: text }: Example): PrintedComparison {
  const right = evaluate(draft).frame?.bytes ?? none;
  const printed = fromHex(text.replaceAll(' ', '')) ?? none;
  const wrongAt = [...printed.keys()].filter((at) => printed[at] !== right[at]);
  const runs: PrintedRun[] = [];
  for (let from = 0; from < printed.length; ) {
    const wrong = wrongAt.includes(from);
    let to = from;
    while (to < printed.length && wrongAt.includes(to) === wrong) to++;
    runs.push({ bytes: printed.subarray(from, to), wrong });
    from = to;
  }
  return { right, printed, runs, wrongAt };
}
