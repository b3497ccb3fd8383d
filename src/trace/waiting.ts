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
const transactionOf = (bytes: Uint8Array): number =>
  bytes.length < 2 ? NO_TRANSACTION : ((bytes[0] as number) << 8) | (bytes[1] as number);
/** The keys of what is not TCP, and of what is too short for a transaction. */
const SERIAL = -1;
const NO_TRANSACTION = -2;

/** What goes between two ends, both ways. */
interface Conversation {
  readonly lines: Map<number, Line>;
  /** The last request, whatever its transaction. */
  last: LastAsked | undefined;
  /** A request that a reply of another transaction seems to answer, until the next request: its own reply may still come. */
  seemsAnswered: LastAsked | undefined;
}

interface LastAsked {
  readonly line: Line;
  readonly asked: Asked;
}

/** Where requests and replies belong together: a serial line, or one transaction of TCP. */
export interface Line {
  readonly conversation: Conversation;
  readonly key: number;
  /** The requests that wait, the oldest first. */
  waiting: Asked[];
}

/**
 * The requests that have no reply yet: on a serial line the last one of each pair of ends, with those given up before it; on TCP one for
 * each transaction identifier (TG 4.4.1.4).
 */
export class Waiting {
  readonly #conversations = new Map<string, Map<string, Conversation>>();

  /** The line of a record; both directions have the same. */
  line(transport: Carried, bytes: Uint8Array, from = '', to = ''): Line {
    const conversation = from < to ? this.#conversation(from, to) : this.#conversation(to, from);
    const key = transport === 'tcp' ? transactionOf(bytes) : SERIAL;
    return conversation.lines.get(key) ?? { conversation, key, waiting: [] };
  }

  #conversation(one: string, other: string): Conversation {
    let ofOne = this.#conversations.get(one);
    if (ofOne === undefined) {
      ofOne = new Map();
      this.#conversations.set(one, ofOne);
    }
    let found = ofOne.get(other);
    if (found === undefined) {
      found = { lines: new Map(), last: undefined, seemsAnswered: undefined };
      ofOne.set(other, found);
    }
    return found;
  }

  /** The last request between the ends of a TCP line, of whatever transaction; `undefined` if it was answered. */
  lastBeside({ conversation: { last } }: Line): LastAsked | undefined {
    return last?.line.waiting.includes(last.asked) ? last : undefined;
  }

  /** The last request waits only until the next one: a reply of another transaction came. */
  seemsAnswered({ conversation }: Line): void {
    conversation.seemsAnswered = conversation.last;
    conversation.last = undefined;
  }

  add(line: Line, asked: Asked): void {
    const { conversation, key } = line;
    if (asked.tcp) {
      const { seemsAnswered } = conversation;
      if (seemsAnswered) this.answered(seemsAnswered.line, seemsAnswered.asked);
      conversation.last = { line, asked };
    }
    const { waiting } = line;
    if (waiting.length === 0) {
      line.waiting = [asked];
      conversation.lines.set(key, line);
      return;
    }
    waiting.push(asked);
    if (waiting.length > MOST_WAITING) waiting.shift();
  }

  /** Forgets a request, which was answered, and those before it on its line. */
  answered(line: Line, asked: Asked): void {
    line.waiting = line.waiting.slice(line.waiting.indexOf(asked) + 1);
    if (line.conversation.seemsAnswered?.asked === asked) line.conversation.seemsAnswered = undefined;
    if (line.waiting.length === 0) line.conversation.lines.delete(line.key);
  }

  /**
   * Takes the requests that wait elsewhere, each as `renumbered` has it, and not if that is `undefined`. Answers which line has become
   * which.
   */
  takeFrom(other: Waiting, renumbered: (asked: Asked) => Asked | undefined): ReadonlyMap<Line, Line> {
    const taken = new Map<Line, Line>();
    for (const [one, ofOne] of other.#conversations) {
      for (const [end, before] of ofOne) {
        const conversation = this.#conversation(one, end);
        const numbers = new Map<Asked, Asked>();
        const again = (asked: Asked) => {
          const now = numbers.get(asked) ?? renumbered(asked);
          if (now) numbers.set(asked, now);
          return now;
        };
        for (const [key, line] of before.lines) {
          const waiting = line.waiting.flatMap((asked) => again(asked) ?? []);
          const now: Line = { conversation, key, waiting };
          taken.set(line, now);
          if (waiting.length > 0) conversation.lines.set(key, now);
        }
        const last = (of: LastAsked | undefined): LastAsked | undefined => {
          const [line, asked] = of ? [taken.get(of.line), numbers.get(of.asked)] : [];
          return line && asked && { line, asked };
        };
        conversation.last = last(before.last);
        conversation.seemsAnswered = last(before.seemsAnswered);
      }
    }
    return taken;
  }
}
