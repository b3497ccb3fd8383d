import { type ReadonlySignal, signal } from '@preact/signals';
import type { Span } from '../../../modbus/index.ts';
import type { ExplainedFrame } from '../explanation/explanation.tsx';

/** Changes the byte at `at` of the frame that is shown. */
export type ByteEdit = (at: number, value: number) => void;

/** What a strip shows, and where its keys are. */
export class StripState {
  readonly of: ReadonlySignal<ExplainedFrame | undefined>;
  /** `undefined` where bytes cannot be changed. */
  readonly edit: ByteEdit | undefined;
  /** The byte that the Tab key comes to. */
  readonly at = signal(0);
  /** The byte that is typed in, with what was typed to begin with. */
  readonly editing = signal<{ readonly at: number; readonly text: string } | undefined>(undefined);
  /** Whether long runs are shown by their ends only. */
  readonly folded = signal(true);

  constructor(of: ReadonlySignal<ExplainedFrame | undefined>, edit: ByteEdit | undefined) {
    this.of = of;
    this.edit = edit;
  }
}

/** A run of more bytes than this can be folded, to so many at each end. */
const LONG = 16;
const ENDS = 4;
/** No legal frame has a longer field; of a longer one the beginning is drawn, and its ends. */
const MOST = 600;
const BEGINNING = 256;

/** Whether a field can be folded. */
export const isLong = ({ from, to }: Span): boolean => to - from > LONG;

/** The bytes of a field that are drawn: up to `head`, and from `tail` on. */
export function drawnOf(span: Span, folded: boolean): { readonly head: number; readonly tail: number } {
  const { from, to } = span;
  const head = folded && isLong(span) ? from + ENDS : to - from > MOST ? from + BEGINNING : to;
  return { head, tail: head < to ? to - ENDS : to };
}
