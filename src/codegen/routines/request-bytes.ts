import { partsOf, type Reading, type Span } from '../../modbus/index.ts';
import type { Expression } from '../code.ts';
import type { Leaf } from '../facts.ts';
import type { Envelope } from './envelope.ts';
import { int, plus, toInt, wordOf } from './terms.ts';

/** A number in each group of a request. */
export interface GroupNumbers {
  readonly from: number;
  readonly stride: number;
  readonly width: number;
  readonly values: readonly number[];
}

/** Where the numbers of a request stand in its bytes. */
export class RequestBytes {
  readonly reading: Reading;
  readonly #bytes: Uint8Array;
  readonly #envelope: Envelope;

  constructor(reading: Reading, bytes: Uint8Array, envelope: Envelope) {
    this.reading = reading;
    this.#bytes = bytes;
    this.#envelope = envelope;
  }

  /** From and to, in bytes; `undefined` if the request has no such field. */
  place(field: string): { readonly from: number; readonly to: number } | undefined {
    const span = this.reading.spans.find(({ name }) => name === field);
    return span && this.#inBytes(span);
  }

  /** A number of the request, as an `int`, from the array `request`. */
  leaf({ name, group }: Leaf): Expression | undefined {
    const span =
      group === undefined
        ? this.reading.spans.find((one) => one.name === name)
        : partsOf(this.reading, this.#bytes, this.#listSpan(group.list))[group.index]?.parts.find(
            (one) => one.name === name,
          );
    return span && this.number(this.#inBytes(span));
  }

  number({ from, to }: { readonly from: number; readonly to: number }): Expression {
    return this.numberAt(int(from), to - from);
  }

  /** The number of one or two bytes at a place. */
  numberAt(at: Expression, width: number): Expression {
    const { byteAt } = this.#envelope;
    return toInt(
      width === 1 ? byteAt('request', at) : wordOf(byteAt('request', at), byteAt('request', plus(at, int(1)))),
    );
  }

  /** A number in each group of a request: where the first stands, how far the next one is, and what they are now. */
  groups(name: string): GroupNumbers | undefined {
    const list = this.reading.spans.find(({ kind }) => kind === 'groups');
    const items = list === undefined ? [] : partsOf(this.reading, this.#bytes, list);
    const places = items.flatMap(({ parts }) =>
      parts.filter((one) => one.name === name).map((one) => this.#inBytes(one)),
    );
    const [first, second] = places;
    if (first === undefined || places.length !== items.length) return undefined;
    const stride = second === undefined ? 0 : second.from - first.from;
    if (places.some(({ from }, index) => from !== first.from + index * stride)) return undefined;
    const values = items.map((item) => Number(item.values[name]));
    return { from: first.from, stride, width: first.to - first.from, values };
  }

  #listSpan(list: string): Span {
    const found = this.reading.spans.find(({ name }) => name === list);
    if (found === undefined) throw new RangeError(`no span ${list}`);
    return found;
  }

  #inBytes({ from, to }: Pick<Span, 'from' | 'to'>) {
    const ascii = this.reading.transport === 'ascii';
    return ascii ? { from: (from - 1) / 2, to: (to - 1) / 2 } : { from, to };
  }
}
