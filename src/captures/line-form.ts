import { crc16 } from '../modbus/index.ts';
import type { ChunkLabel, TextRange } from '../notation/index.ts';
import { isAdu } from '../trace/index.ts';

/** Stands for any digit in the head of a form. */
const ANY_DIGIT = -1;
const MOST_BYTES = 300;
const LEAST_BYTES = 4;
const PAIR = 2;

/** What a line has outside its bytes that may be bytes and is not taken for them, from where the line begins or its tail does. */
interface Aside {
  readonly from: number;
  readonly to: number;
  readonly inTail: boolean;
}

/** Numbers of so many digits are not said to be set aside if they are more than a byte. */
const WIDE = 3;
const LARGEST = 0xff;
const NOTHING = new Uint8Array(0);

/**
 * The form of a line of a log: what stands before its bytes, with all digits alike, between them and behind them, and what that says of
 * them. Bytes are pairs of hexadecimal digits. A line has the form only if its bytes are a frame whose CRC or MBAP holds, so that nothing
 * else can be meant. A line without bytes has a form, too.
 */
export class LineForm {
  readonly #head: readonly number[];
  readonly #between: string;
  readonly #tail: string;
  /** What belongs to a byte before its digits, in characters, such as `\\x`. */
  readonly #prefix: number;
  /** What all lines of this form say of their bytes; each has its own time. */
  readonly says: ChunkLabel;
  /** Where the time stands in the head. */
  readonly #time: TextRange | undefined;
  readonly #room = new Uint8Array(MOST_BYTES);
  readonly #asides: readonly Aside[];
  readonly #isEmpty: boolean;

  private constructor(
    head: string,
    between: string,
    tail: string,
    prefix: number,
    label: ChunkLabel,
    time: TextRange | undefined,
    asides: readonly Aside[],
    isEmpty: boolean,
  ) {
    this.#asides = asides;
    this.#isEmpty = isEmpty;
    this.#head = Array.from({ length: head.length }, (_, at) => {
      const code = head.charCodeAt(at);
      return isDigit(code) ? ANY_DIGIT : code;
    });
    this.#between = between;
    this.#tail = tail;
    this.#prefix = prefix;
    this.says = label;
    this.#time = time;
  }

  /** The form of the line `[start, end)` of a text, whose bytes stand at `places`; `undefined` if it has none. */
  static of(
    text: string,
    start: number,
    end: number,
    places: readonly TextRange[],
    label: ChunkLabel,
    aside: readonly TextRange[] = [],
  ): LineForm | undefined {
    if (places.length === 0) {
      const asides = aside.map((one) => ({ from: one.start - start, to: one.end - start, inTail: false }));
      return new LineForm(text.slice(start, end), '', '', 0, {}, undefined, asides, true);
    }
    const pairs = places.map((place) => place.end - PAIR);
    const [prefix = 0, ...others] = places.map((place) => place.end - PAIR - place.start);
    if (prefix < 0 || others.some((one) => one !== prefix)) return undefined;
    const [first, second] = pairs;
    const last = pairs.at(-1);
    if (first === undefined || second === undefined || last === undefined) return undefined;
    const head = text.slice(start, first);
    const time = label.time === undefined ? -1 : head.indexOf(label.time);
    if (label.time !== undefined && time < 0) return undefined;
    const tail = last + PAIR;
    const begin = places[0]?.start ?? first;
    if (aside.some((one) => one.end > begin && one.start < tail)) return undefined;
    const asides = aside.map((one) => {
      const inTail = one.start >= tail;
      const base = inTail ? tail : start;
      return { from: one.start - base, to: one.end - base, inTail };
    });
    return new LineForm(
      head,
      text.slice(first + PAIR, second),
      text.slice(last + PAIR, end),
      prefix,
      label,
      label.time === undefined ? undefined : { start: time, end: time + label.time.length },
      asides,
      false,
    );
  }

  /** The bytes of the line `[start, end)`, until the next line is read; `undefined` if it does not have this form. */
  bytes(text: string, start: number, end: number): Uint8Array | undefined {
    const head = this.#head;
    if (end - start < head.length) return undefined;
    for (let at = 0; at < head.length; at++) {
      const code = text.charCodeAt(start + at);
      if (head[at] !== (isDigit(code) ? ANY_DIGIT : code)) return undefined;
    }
    if (this.#isEmpty) return end - start === head.length ? NOTHING : undefined;
    const step = PAIR + this.#between.length;
    const stop = end - this.#tail.length;
    let count = 0;
    for (let at = start + head.length; at + PAIR <= stop && count < MOST_BYTES; at += step) {
      const value = (hexDigit(text.charCodeAt(at)) << 4) | hexDigit(text.charCodeAt(at + 1));
      if (value < 0) return undefined;
      this.#room[count++] = value;
      if (at + PAIR === stop) break;
      if (!text.startsWith(this.#between, at + PAIR)) return undefined;
    }
    if (count < LEAST_BYTES || start + head.length + (count - 1) * step + PAIR !== stop) return undefined;
    if (!text.startsWith(this.#tail, stop)) return undefined;
    const bytes = this.#room.subarray(0, count);
    return crc16(bytes) === 0 || isAdu(bytes) ? bytes : undefined;
  }

  /** The time in a line of this form that begins at `start`. */
  time(text: string, start: number): string | undefined {
    return this.#time && text.slice(start + this.#time.start, start + this.#time.end);
  }

  /** What is set aside in a line `[start, end)` of this form. */
  asides(text: string, start: number, end: number): readonly TextRange[] {
    if (this.#asides.length === 0) return [];
    return this.#asides
      .map(({ from, to, inTail }) => {
        const base = inTail ? end - this.#tail.length : start;
        return { start: base + from, end: base + to };
      })
      .filter((range) => range.end - range.start !== WIDE || !(Number(text.slice(range.start, range.end)) > LARGEST));
  }

  /** Where a byte stands in a line that begins at `start`. */
  place(start: number, index: number): TextRange {
    const digits = start + this.#head.length + index * (PAIR + this.#between.length);
    return { start: digits - this.#prefix, end: digits + PAIR };
  }
}

const isDigit = (code: number): boolean => code >= 0x30 && code <= 0x39;

/** The value of a hexadecimal digit; negative if it is not one. */
function hexDigit(code: number): number {
  if (isDigit(code)) return code - 0x30;
  const letter = (code | 0x20) - 0x61;
  return letter >= 0 && letter < 6 ? letter + 10 : -1;
}
