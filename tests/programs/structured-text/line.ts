import type { Instance, Machine } from './machine.ts';

/** A device on a line, as the program around a function block passes its bytes. */
export interface Line {
  /** What comes back for a request; `undefined` if nothing does. */
  readonly reply: (request: readonly number[]) => readonly number[] | undefined;
  /** Whether the adapter gives back what is sent. */
  readonly echo?: boolean;
  /** Bytes that come in a cycle; 4 by default. */
  readonly aCycle?: number;
  /** Milliseconds a cycle takes; 10 by default. */
  readonly cycle?: number;
  /** Bytes that stand there before the block begins. */
  readonly before?: readonly number[];
}

export interface Carried {
  /** What was sent, and when. */
  readonly sent: readonly { readonly at: number; readonly bytes: readonly number[] }[];
  /** When the block ended; `undefined` if it was still busy at the end of the time. */
  readonly ended: number | undefined;
}

const MOST_TIME = 60_000;

/** Calls a function block in every cycle until it has ended, and passes bytes as its comments say. */
export function carryOut(
  machine: Machine,
  block: Instance,
  line: Line,
  given: (now: number) => object = () => ({}),
): Carried {
  const { reply, echo = false, aCycle = 4, cycle = 10, before = [] } = line;
  const buffer = machine.frame();
  for (const [at, one] of before.entries()) buffer[at] = one;
  let count = before.length;
  let coming: number[] = [];
  const sent: { at: number; bytes: readonly number[] }[] = [];
  const receives = block.has('RxBuffer');
  for (const begin = machine.now; machine.now - begin < MOST_TIME; machine.now += cycle) {
    for (const one of coming.splice(0, aCycle)) buffer[count++] = one;
    block.cycle({ Execute: true, ...given(machine.now), ...(receives && { RxBuffer: buffer, RxCount: count }) });
    if (receives) count = Number(block.get('RxCount'));
    if (block.get('TxStart') === true) {
      const bytes = (block.get('TxBuffer') as number[]).slice(0, Number(block.get('TxCount')));
      sent.push({ at: machine.now - begin, bytes });
      coming = [...(echo ? bytes : []), ...(reply(bytes) ?? [])];
    }
    if (block.get('Busy') === false) return { sent, ended: machine.now - begin };
  }
  return { sent, ended: undefined };
}
