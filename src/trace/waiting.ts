import type { Carried } from './record.ts';

/** A request that may still be answered. */
export interface Asked {
  readonly exchange: number;
  readonly record: number;
  /** Something is wrong with it, so that silence is the right reply. */
  readonly damaged: boolean;
  readonly time: number | undefined;
  readonly tcp: boolean;
}

/** Requests of one line or connection that wait, or were given up. */
const MOST_WAITING = 64;

/**
 * The requests that have no reply yet: on a serial line the last one of each pair of ends, with those given up before it; on TCP one for
 * each transaction identifier (TG 4.4.1.4).
 */
export class Waiting {
  readonly #lines = new Map<string, Asked[]>();
  /** The last request between two ends, whatever its transaction. */
  readonly #last = new Map<string, { readonly line: string; readonly asked: Asked }>();

  /** The line of a record; both directions have the same. */
  static line(transport: Carried, bytes: Uint8Array, from = '', to = ''): string {
    const ends = from < to ? `${from}|${to}` : `${to}|${from}`;
    return transport === 'tcp' ? `${ends}|${bytes[0]} ${bytes[1]}` : ends;
  }

  /** The last request between the ends of a TCP line, of whatever transaction; `undefined` if it was answered. */
  lastBeside(line: string): { readonly line: string; readonly asked: Asked } | undefined {
    const last = this.#last.get(endsOf(line));
    return last && this.on(last.line).includes(last.asked) ? last : undefined;
  }

  /** The requests of a line that wait, the oldest first. */
  on(line: string): readonly Asked[] {
    return this.#lines.get(line) ?? NONE;
  }

  add(line: string, asked: Asked): void {
    const waiting = this.#lines.get(line);
    if (asked.tcp) this.#last.set(endsOf(line), { line, asked });
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

/** The line of TCP without its transaction. */
const endsOf = (line: string): string => line.slice(0, line.lastIndexOf('|'));
