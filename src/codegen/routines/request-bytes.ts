import { partsOf, type Reading, type Span } from '../../modbus/index.ts';
import type { Expression } from '../code.ts';
import type { Leaf } from '../facts.ts';
import type { Envelope } from './envelope.ts';
import { int, toInt, wordOf } from './terms.ts';

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
    const at = (index: number) => this.#envelope.byteAt('request', int(index));
    return toInt(to - from === 1 ? at(from) : wordOf(at(from), at(from + 1)));
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
