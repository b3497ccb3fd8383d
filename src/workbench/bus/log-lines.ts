import type { LogLine } from '../../bus/index.ts';
import { type DecodeContext, decodeFrame, fromHex, type Reading, spacedHex } from '../../modbus/index.ts';

/** Which lines are shown. */
export type LogFilter = 'all' | 'frames' | 'troubles';

/** What is said of a line. */
export interface LineWords {
  readonly kinds: Readonly<Record<LogLine['kind'], string>>;
  /** Of bytes that are not a frame. */
  readonly noMeaning: (count: number) => string;
  readonly frame: (reading: Reading, size: number, transport: LogLine['transport']) => string;
}

const NONE = new Uint8Array(0);
const REPLIES: ReadonlySet<LogLine['kind']> = new Set(['reply', 'exception', 'late']);
const REQUESTS: ReadonlySet<LogLine['kind']> = new Set(['request', 'echo']);
const FRAMES: ReadonlySet<LogLine['kind']> = new Set([...REPLIES, ...REQUESTS, 'heard']);
const GOOD: ReadonlySet<LogLine['verdict']> = new Set([undefined, 'good', 'absent']);

export const lineBytes = ({ hex }: LogLine): Uint8Array => fromHex(hex) ?? NONE;

/** The frame that a line holds; `undefined` if it is noise. */
export function lineReading(line: LogLine, request: Uint8Array | undefined): Reading | undefined {
  if (line.kind === 'noise') return undefined;
  const bytes = lineBytes(line);
  const { transport } = line;
  if (REQUESTS.has(line.kind) || (line.kind === 'heard' && line.direction === 'sent'))
    return decodeFrame(bytes, { transport, direction: 'request' });
  const context: DecodeContext = { transport, direction: 'response', ...(request && { request }) };
  const reading = decodeFrame(bytes, context);
  if (line.kind !== 'heard' || isSound(reading)) return reading;
  const asRequest = decodeFrame(bytes, { transport, direction: 'request' });
  return isSound(asRequest) ? asRequest : reading;
}

const isSound = ({ outcome, problems }: Reading): boolean =>
  outcome.kind === 'whole' && problems.every(({ severity }) => severity !== 'error');

/** What a line means, in a sentence. */
export function lineMeaning(line: LogLine, words: LineWords): string {
  const reading = lineReading(line, undefined);
  const size = line.hex.length / 2;
  return reading === undefined ? words.noMeaning(size) : words.frame(reading, size, line.transport);
}

/** Whether something is wrong with what a line stands for. */
export const isLineTrouble = ({ kind, verdict }: LogLine): boolean =>
  // While this page listens, it hears the talk of others; at any other time nobody has asked for what is heard.
  kind === 'heard'
    ? verdict !== 'good'
    : !GOOD.has(verdict) || !(REPLIES.has(kind) || REQUESTS.has(kind)) || kind === 'late' || kind === 'exception';

/** Lines by their kind, and by a search for bytes or for words of the meaning. Each line is looked at once. */
export class LineSearch {
  readonly #seen = new WeakMap<LogLine, boolean>();
  readonly #filter: LogFilter;
  readonly #wanted: string;
  /** What is wanted as digits of bytes; `undefined` if it is not that. */
  readonly #digits: string | undefined;
  readonly #words: LineWords;

  constructor(filter: LogFilter, search: string, words: LineWords) {
    const digits = search.replaceAll(/[\s,]|0x/gi, '').toUpperCase();
    this.#filter = filter;
    this.#wanted = search.trim().toLowerCase();
    this.#digits = /^[0-9A-F]+$/.test(digits) ? digits : undefined;
    this.#words = words;
  }

  /** The lines of a log that are shown. */
  shown(log: readonly LogLine[]): readonly LogLine[] {
    if (this.#filter === 'all' && this.#wanted === '') return log;
    return log.filter((line) => {
      const seen = this.#seen.get(line) ?? this.#shows(line);
      this.#seen.set(line, seen);
      return seen;
    });
  }

  #shows(line: LogLine): boolean {
    if (this.#filter === 'troubles' && !isLineTrouble(line)) return false;
    if (this.#filter === 'frames' && !FRAMES.has(line.kind)) return false;
    if (this.#wanted === '') return true;
    if (this.#digits !== undefined && line.hex.includes(this.#digits)) return true;
    return `${this.#words.kinds[line.kind]} ${lineMeaning(line, this.#words)} ${spacedHex(line.hex)}`
      .toLowerCase()
      .includes(this.#wanted);
  }
}
