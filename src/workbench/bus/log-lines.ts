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
const GOOD: ReadonlySet<LogLine['verdict']> = new Set([undefined, 'good']);

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

/** The lines that are shown, with a search for bytes or for words of the meaning. */
export function shownLines(
  log: readonly LogLine[],
  filter: LogFilter,
  search: string,
  words: LineWords,
): readonly LogLine[] {
  const digits = search.replaceAll(/[\s,]|0x/gi, '').toUpperCase();
  const asBytes = /^[0-9A-F]+$/.test(digits) ? digits : undefined;
  const wanted = search.trim().toLowerCase();
  if (filter === 'all' && wanted === '') return log;
  return log.filter((line) => {
    if (filter === 'troubles' && !isLineTrouble(line)) return false;
    if (filter === 'frames' && !FRAMES.has(line.kind)) return false;
    if (wanted === '') return true;
    if (asBytes !== undefined && line.hex.includes(asBytes)) return true;
    return `${words.kinds[line.kind]} ${lineMeaning(line, words)} ${spacedHex(line.hex)}`
      .toLowerCase()
      .includes(wanted);
  });
}
