import type { Direction } from '../modbus/index.ts';
import {
  type ByteText,
  type Chunk,
  type ChunkLabel,
  readBytes,
  type TextProblem,
  type TextRange,
} from '../notation/index.ts';
import { type Column, countsColumn } from '../trace/index.ts';
import { LineForm } from './line-form.ts';

/** A chunk of a log; what its writer sent is taken for a request until more is known. */
export interface LogChunk extends Pick<Chunk, 'from' | 'to'> {
  readonly direction: Direction | undefined;
  readonly transport: Chunk['transport'] | undefined;
  readonly time: string | undefined;
}

/** The bytes of a log, as `readBytes` reads them, and where each stands. */
export interface LogBytes extends Pick<ByteText, 'bytes' | 'problems'> {
  readonly chunks: readonly LogChunk[];
  /** Where the bytes `[from, to)` stand in the text. */
  place(from: number, to: number): TextRange;
}

/** Lines from which forms are learned at a time. */
const LEARNED = 2000;
/** Lines before and behind one without a form that are read with it. */
const CONTEXT = 3;
/** Lines without a form that are read at a time, if they stand apart. */
const BATCH = 4000;
const MOST_FORMS = 64;
/** What is said of the bytes of another line. */
const OF_OTHERS = /crc|lrc|checksum/i;
/** Forms are learned again where more than one line of so many has none, but not without end where that is in vain. */
const FEW = 10;
const VAIN = 3;

const DIRECTIONS = { request: 'request', response: 'response', tx: 'request', rx: 'response' } as const;
const logChunk = ({ direction, transport, time }: ChunkLabel, from: number, to: number, itsTime = time): LogChunk => ({
  from,
  to,
  direction: direction && DIRECTIONS[direction],
  transport,
  time: itsTime,
});

/** What `readBytes` says of a log of few lines. */
export function readShortLog(text: string, tell?: (done: number) => void): LogBytes {
  const { bytes, origin, chunks, problems } = readBytes(text, undefined, tell);
  return {
    bytes,
    chunks: chunks.map((chunk) => logChunk(chunk, chunk.from, chunk.to)),
    problems,
    place: (from, to) => ({ start: origin[from]?.start ?? 0, end: origin[to - 1]?.end ?? 0 }),
  };
}

/**
 * The bytes of a log of many lines. What `readBytes` says of some of them it says of all of the same form, which are then read by the
 * form; the others are read by it, with their neighbours. `learned` lines are looked at together.
 */
export function readLongLog(text: string, tell: (done: number) => void = () => undefined, learned = LEARNED): LogBytes {
  const lines = new Lines(text);
  const { forms, formOf } = formsOf(text, lines, learned);
  const log = new Writer(text);
  let block = 0;
  const blocks = blocksOf(formOf);
  let aside: Aside[] = [];
  for (let line = 0; line < lines.count; line++) {
    if (blocks[block]?.from === line) {
      const batch = batchFrom(blocks, block);
      const read = readAside(text, lines, formOf, batch);
      aside = [...aside, ...read.aside];
      // A call takes only so many arguments.
      for (const problem of read.problems) log.problems.push(problem);
      block += batch.length;
    }
    const [start, end] = [lines.start(line), lines.end(line)];
    const known = forms[(formOf[line] ?? 0) - 1];
    if (known) log.line(known.form, start, end);
    else {
      const count = aside.findIndex(({ places: [first] }) => (first?.start ?? 0) >= lines.start(line + 1));
      for (const one of aside.splice(0, count < 0 ? aside.length : count)) log.aside(one);
    }
    if (line % LEARNED === 0) tell(line / lines.count);
  }
  return log.done();
}

/** Where lines begin and end. */
class Lines {
  readonly #starts = countsColumn();
  readonly #length: number;

  constructor(text: string) {
    this.#length = text.length;
    for (let start = 0; start < text.length; ) {
      this.#starts.push(start);
      const end = text.indexOf('\n', start);
      start = end < 0 ? text.length : end + 1;
    }
  }

  get count(): number {
    return this.#starts.length;
  }

  /** Behind the last line the text ends. */
  start(line: number): number {
    return line < this.count ? this.#starts.at(line) : this.#length;
  }

  /** Where a line ends, before its line end. */
  end(line: number): number {
    const next = this.start(line + 1);
    return line + 1 < this.count ? next - 1 : next;
  }

  /** The line that has a place of the text. */
  at(place: number): number {
    let [low, high] = [0, this.count - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.#starts.at(middle) <= place) low = middle;
      else high = middle - 1;
    }
    return low;
  }
}

/** The forms of the lines, and for each line the number of its form, from 1; 0 for a line without one. */
function formsOf(text: string, lines: Lines, learned: number) {
  const forms: KnownForm[] = [];
  const formOf = new Uint8Array(lines.count);
  const match = (from: number, to: number) => {
    let without = 0;
    let last = 0;
    for (let line = from; line < to; line++) {
      const [start, end] = [lines.start(line), lines.end(line)];
      formOf[line] = 0;
      for (let tried = 0; tried < forms.length; tried++) {
        const number = (last + tried) % forms.length;
        const known = forms[number];
        if (known?.form.bytes(text, start, end) === undefined) continue;
        if (known.holds) formOf[line] = number + 1;
        // Requests and replies take turns.
        last = number + 1;
        break;
      }
      if (formOf[line] === 0) without++;
    }
    return without;
  };
  let vain = 0;
  for (let from = 0; from < lines.count && vain < VAIN; from += learned) {
    const to = Math.min(lines.count, from + learned);
    if (match(from, to) * FEW <= to - from || forms.length >= MOST_FORMS) continue;
    learn(text, lines, from, to, forms);
    vain = 2 * match(from, to) > to - from ? vain + 1 : 0;
  }
  // One that did not hold in the end may have been taken before.
  for (let line = 0; line < lines.count; line++) if (!forms[(formOf[line] ?? 0) - 1]?.holds) formOf[line] = 0;
  return { forms, formOf };
}

/** A form, and whether all lines that have it are read by it alone: not what `readBytes` says otherwise of one of them. */
interface KnownForm {
  readonly form: LineForm;
  holds: boolean;
}

/** Adds the forms of some lines, and finds out which forms do not hold for them. */
function learn(text: string, lines: Lines, from: number, to: number, forms: KnownForm[]): void {
  // What a line says may be said before it.
  const shift = lines.start(Math.max(0, from - CONTEXT));
  const { bytes, origin, chunks, problems } = readBytes(text.slice(shift, lines.start(to)));
  /** What stands in a line; `undefined` if it is not just one chunk. */
  const said = new Map<number, Chunk | undefined>();
  const lineOf = (place: number) => lines.at(shift + place);
  const placed = ({ start, end }: TextRange) => ({ start: shift + start, end: shift + end });
  for (const chunk of chunks) {
    const first = lineOf(origin[chunk.from]?.start ?? 0);
    const last = lineOf((origin[chunk.to - 1]?.end ?? 1) - 1);
    const isOne = first === last && !said.has(first) && chunk.reading === undefined;
    for (let line = first; line <= last; line++) said.set(line, isOne ? chunk : undefined);
  }
  /** What is set aside in a line, by its words. */
  const asides = new Map<number, TextRange[]>();
  for (const problem of problems) {
    const [first, last] = [lineOf(problem.start), lineOf(Math.max(problem.start, problem.end - 1))];
    const isAside = first === last && problem.code === 'set-aside' && problem.why === 'words';
    if (isAside) asides.set(first, [...(asides.get(first) ?? []), placed(problem)]);
    else for (let line = first; line <= last; line++) said.set(line, undefined);
  }
  const bounds = (line: number) => [lines.start(line), lines.end(line)] as const;
  for (let line = from; line < to && forms.length < MOST_FORMS; line++) {
    const chunk = said.get(line);
    if (chunk === undefined && said.has(line)) continue;
    const [start, end] = bounds(line);
    if (forms.some(({ form }) => form.bytes(text, start, end))) continue;
    if (chunk === undefined && OF_OTHERS.test(text.slice(start, end))) continue;
    const places = chunk === undefined ? [] : origin.slice(chunk.from, chunk.to).map(placed);
    const form = LineForm.of(text, start, end, places, labelOf(chunk), asides.get(line));
    if (form?.bytes(text, start, end) !== undefined) forms.push({ form, holds: true });
  }
  for (let line = from; line < to; line++) {
    const [start, end] = bounds(line);
    for (const known of forms) {
      const { form, holds } = known;
      const got = holds ? form.bytes(text, start, end) : undefined;
      if (got === undefined) continue;
      const chunk = said.get(line) ?? { from: 0, to: 0 };
      const isKnown = said.get(line) !== undefined || !said.has(line);
      const isSame =
        isKnown &&
        got.length === chunk.to - chunk.from &&
        areSame(form.asides(text, start, end), asides.get(line) ?? []) &&
        got.every((byte, index) => byte === bytes[chunk.from + index]) &&
        form.says.direction === chunk.direction &&
        form.says.transport === chunk.transport &&
        form.time(text, start) === chunk.time;
      if (!isSame) known.holds = false;
    }
  }
}

const areSame = (some: readonly TextRange[], others: readonly TextRange[]): boolean =>
  some.length === others.length && some.every(({ start }, index) => start === others[index]?.start);

/** What a chunk says of its bytes. */
function labelOf(chunk: Chunk | undefined): ChunkLabel {
  if (chunk === undefined) return {};
  const { from: _from, to: _to, ...label } = chunk;
  return label;
}

interface Block {
  readonly from: number;
  readonly to: number;
}

/** The lines without a form, with those around them. */
function blocksOf(formOf: Uint8Array): readonly Block[] {
  const blocks: { from: number; to: number }[] = [];
  for (let line = formOf.indexOf(0); line >= 0; line = formOf.indexOf(0, line + 1)) {
    const last = blocks.at(-1);
    const [from, to] = [Math.max(0, line - CONTEXT), Math.min(formOf.length, line + 1 + CONTEXT)];
    if (last && from <= last.to) last.to = to;
    else blocks.push({ from, to });
  }
  return blocks;
}

function batchFrom(blocks: readonly Block[], first: number): readonly Block[] {
  let count = 0;
  let end = first;
  for (let block = blocks[end]; block && (count === 0 || count + block.to - block.from <= BATCH); block = blocks[end]) {
    count += block.to - block.from;
    end++;
  }
  return blocks.slice(first, end);
}

/** A chunk in lines without a form. */
interface Aside {
  readonly bytes: readonly number[];
  readonly places: readonly TextRange[];
  readonly label: ChunkLabel;
}

/** What `readBytes` says of the lines without a form in some blocks. */
function readAside(text: string, lines: Lines, formOf: Uint8Array, blocks: readonly Block[]) {
  // An empty line parts what does not stand together.
  const starts: { readonly at: number; readonly shift: number }[] = [];
  let joined = '';
  for (const { from, to } of blocks) {
    starts.push({ at: joined.length, shift: lines.start(from) - joined.length });
    joined += `${text.slice(lines.start(from), lines.end(to - 1))}\n\n`;
  }
  const shiftAt = (place: number) => {
    let [low, high] = [0, starts.length - 1];
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if ((starts[middle]?.at ?? 0) <= place) low = middle;
      else high = middle - 1;
    }
    return starts[low]?.shift ?? 0;
  };
  const placed = <T extends TextRange>(range: T): T => {
    const shift = shiftAt(range.start);
    return { ...range, start: range.start + shift, end: range.end + shift };
  };
  const isAside = ({ start }: TextRange) => formOf[lines.at(start)] === 0;
  const { bytes, origin, chunks, problems } = readBytes(joined);
  const aside: Aside[] = [];
  for (const { from, to, ...label } of chunks) {
    const own: number[] = [];
    const places: TextRange[] = [];
    for (let at = from; at < to; at++) {
      const place = placed(origin[at] ?? { start: 0, end: 0 });
      if (!isAside(place)) continue;
      own.push(bytes[at] ?? 0);
      places.push(place);
    }
    if (own.length > 0) aside.push({ bytes: own, places, label });
  }
  return { aside, problems: problems.map(placed).filter(isAside) };
}

/** Puts together what was read. */
class Writer {
  readonly problems: TextProblem[] = [];
  readonly #text: string;
  readonly #chunks: LogChunk[] = [];
  #bytes = new Uint8Array(1 << 16);
  #length = 0;
  readonly #starts: Column = countsColumn();
  readonly #ends: Column = countsColumn();

  constructor(text: string) {
    this.#text = text;
  }

  line(form: LineForm, start: number, end: number): void {
    const bytes = form.bytes(this.#text, start, end);
    if (bytes === undefined) return;
    for (const range of form.asides(this.#text, start, end))
      this.problems.push({ code: 'set-aside', ...range, why: 'words' });
    if (bytes.length === 0) return;
    const from = this.#length;
    for (let index = 0; index < bytes.length; index++) {
      const place = form.place(start, index);
      this.#byte(bytes[index] as number, place.start, place.end);
    }
    this.#chunks.push(logChunk(form.says, from, this.#length, form.time(this.#text, start)));
  }

  aside({ bytes, places, label }: Aside): void {
    const from = this.#length;
    bytes.forEach((byte, index) => {
      const { start, end } = places[index] as TextRange;
      this.#byte(byte, start, end);
    });
    this.#chunks.push(logChunk(label, from, this.#length));
  }

  #byte(value: number, start: number, end: number): void {
    if (this.#length === this.#bytes.length) {
      const wider = new Uint8Array(2 * this.#length);
      wider.set(this.#bytes);
      this.#bytes = wider;
    }
    this.#bytes[this.#length++] = value;
    this.#starts.push(start);
    this.#ends.push(end);
  }

  done(): LogBytes {
    const [starts, ends] = [this.#starts, this.#ends];
    return {
      bytes: this.#bytes.slice(0, this.#length),
      chunks: this.#chunks,
      problems: this.problems,
      place: (from, to) => ({ start: starts.at(from), end: ends.at(to - 1) }),
    };
  }
}
