import type { Carried } from './record.ts';

/** A request that may still be answered. */
export interface Asked {
  readonly exchange: number;
  readonly record: number;
  /** Something is wrong with it, so that silence is the right reply. */
  readonly damaged: boolean;
  readonly time: number | undefined;
}

/** Requests of one line or connection that wait, or were given up. */
const MOST_WAITING = 64;

/**
 * The requests that have no reply yet: on a serial line the last one of each pair of ends, with those given up before it; on TCP one for
 * each transaction identifier (TG 4.4.1.4).
 */
export class Waiting {
  readonly #lines = new Map<string, Asked[]>();

  /** The line of a record; both directions have the same. */
  static line(transport: Carried, bytes: Uint8Array, from = '', to = ''): string {
    const ends = from < to ? `${from}|${to}` : `${to}|${from}`;
    return transport === 'tcp' ? `${ends}|${bytes[0]} ${bytes[1]}` : ends;
  }

  /** The requests of a line that wait, the oldest first. */
  on(line: string): readonly Asked[] {
    return this.#lines.get(line) ?? NONE;
  }

  add(line: string, asked: Asked): void {
    const waiting = this.#lines.get(line);
    if (waiting === undefined) this.#lines.set(line, [asked]);
    else {
      waiting.push(asked);
      if (waiting.length > MOST_WAITING) waiting.shift();
    }
  }

  /** Forgets a request, which was answered, and those before it on its line. */
  answered(line: string, asked: Asked): void {
    const waiting = this.#lines.get(line);
    if (waiting === undefined) return;
    const left = waiting.slice(waiting.indexOf(asked) + 1);
    if (left.length > 0) this.#lines.set(line, left);
    else this.#lines.delete(line);
  }
}

const NONE: readonly Asked[] = Object.freeze([]);
