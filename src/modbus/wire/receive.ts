import { demandFinite, demandPositive } from '../demand.ts';
import { demandFormat, type SerialFormat } from '../timing/index.ts';
import { type Level, parityBit } from './character.ts';

/** How a receiver is set, and how its wires are joined. */
export interface Receiver {
  readonly format: SerialFormat;
  /** The length of its bit, in bit times of the sender: 0.5 at twice the sender's speed. */
  readonly bit: number;
  /** Whether its two wires are swapped, so that it sees each level as the other. */
  readonly inverted?: boolean | undefined;
}

/** What is wrong with a received character: its parity, its stop bit, or nothing but zeros with no stop bit at all. */
export type ReceiveError = 'parity' | 'framing' | 'break';

/** A character as a receiver has it. */
export interface ReceivedCharacter {
  readonly value: number;
  readonly errors: readonly ReceiveError[];
  /** Its start edge and the sample of its stop bit, in bit times of the sender. */
  readonly start: number;
  readonly end: number;
}

/**
 * What a receiver reads from the changes of level that `edgesOf` gives: a fall begins a character; each bit is sampled
 * in its middle, and only the first of the stop bits; the next fall after that begins the next character. That is how most
 * UARTs work; they differ in what they do after a wrong stop bit. A sample at the very moment of a change has the new level;
 * at half the sender's speed every sample is one, and a real receiver may see either level. Takes time linear in the number of
 * edges. Throws a `RangeError` for edges that are not finite or descend, for a bit time that is not above 0, and for a format
 * that does not exist.
 */
export function receive(edges: readonly number[], { format, bit, inverted = false }: Receiver): ReceivedCharacter[] {
  demandFormat(format);
  demandPositive('bit time', bit, 'not-zero');
  demandAscending(edges);
  const { dataBits, parity } = format;
  const received: ReceivedCharacter[] = [];
  // The level is 1 while an even number of edges has passed, or an odd one if the wires are swapped.
  let passed = 0;
  const levelAt = (time: number): Level => {
    while (passed < edges.length && (edges[passed] as number) <= time) passed++;
    return ((passed % 2 === 0) !== inverted ? 1 : 0) as Level;
  };
  const isFall = (edge: number) => (edge % 2 === 0) !== inverted;
  while (passed < edges.length) {
    if (!isFall(passed)) {
      passed++;
      continue;
    }
    const start = edges[passed] as number;
    const look = (index: number) => levelAt(start + (index + 0.5) * bit);
    // A start bit that has ended by its middle is taken for a disturbance.
    if (look(0) === 1) continue;
    let value = 0;
    for (let index = 0; index < dataBits; index++) value |= look(1 + index) << index;
    const checked = parity !== 'none';
    const check = checked ? look(1 + dataBits) : 0;
    const last = 1 + dataBits + (checked ? 1 : 0);
    const stop = look(last);
    const errors: ReceiveError[] = [];
    if (stop === 0 && value === 0 && check === 0) errors.push('break');
    else {
      if (checked && check !== parityBit(value, format)) errors.push('parity');
      if (stop === 0) errors.push('framing');
    }
    received.push({ value, errors, start, end: start + (last + 0.5) * bit });
  }
  return received;
}

function demandAscending(edges: readonly number[]): void {
  let before = -Infinity;
  for (const edge of edges) {
    demandFinite('edge', edge);
    if (edge < before) throw new RangeError(`an edge at ${edge} behind one at ${before}`);
    before = edge;
  }
}
