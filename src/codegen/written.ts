/** A file of a program. `lines` are those that have to do with bytes of the frame: their number, from 1, and the spans by name. */
export interface WrittenFile {
  readonly name: string;
  readonly text: string;
  readonly lines: readonly { readonly line: number; readonly spans: readonly string[] }[];
}

const STEP = '  ';

/** The lines of a file, written one after another, with the spans that each has to do with. */
export class Lines {
  readonly #lines: string[] = [];
  readonly #spans: (readonly string[])[] = [];
  readonly #step: string;
  readonly #gap: number;
  #depth = 0;

  /** `step` is what a line is set in by, `gap` how many empty lines part a routine from another. */
  constructor(step: string = STEP, gap: number = 1) {
    this.#step = step;
    this.#gap = gap;
  }

  /** Adds a line, or several; an empty text makes an empty line, of which two never follow each other. */
  add(text: string, spans: readonly string[] = []): this {
    if (text.includes('\n')) {
      for (const line of text.split('\n')) this.add(line, spans);
      return this;
    }
    if (text === '' && (this.#lines.at(-1) ?? '') === '') return this;
    this.#lines.push(text === '' ? '' : this.#step.repeat(this.#depth) + text);
    this.#spans.push(spans);
    return this;
  }

  /** Adds the empty lines that part a routine from what stands before it. */
  part(): this {
    while ((this.#lines.at(-1) ?? '') === '' && this.#lines.length > 0) {
      this.#lines.pop();
      this.#spans.pop();
    }
    for (let more = this.#lines.length === 0 ? 0 : this.#gap; more > 0; more--) {
      this.#lines.push('');
      this.#spans.push([]);
    }
    return this;
  }

  /** Adds the lines of a text, without spans. */
  text(lines: string): this {
    for (const line of lines.split('\n')) this.add(line.trimEnd());
    return this;
  }

  /** Adds what `inside` adds, set in by one step. */
  inside(inside: () => void): this {
    this.#depth++;
    inside();
    this.#depth--;
    return this;
  }

  file(name: string): WrittenFile {
    const lines = this.#spans.flatMap((spans, index) => (spans.length === 0 ? [] : [{ line: index + 1, spans }]));
    return { name, text: `${this.#lines.join('\n').trimEnd()}\n`, lines };
  }
}
