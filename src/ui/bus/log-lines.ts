import type { LogLine } from '../../bus/index.ts';
import { type DecodeContext, decodeFrame, fromHex, type Reading, spacedHex } from '../../modbus/index.ts';
import { words as pageWords } from '../language.ts';
import { busWords as words } from './language.ts';

/** Which lines are shown. */
export type Filter = keyof typeof words.log.filters;

const NONE = new Uint8Array(0);
const REPLIES: ReadonlySet<LogLine['kind']> = new Set(['reply', 'exception', 'late']);
const REQUESTS: ReadonlySet<LogLine['kind']> = new Set(['request', 'echo']);
const FRAMES: ReadonlySet<LogLine['kind']> = new Set([...REPLIES, ...REQUESTS, 'heard']);
const GOOD: ReadonlySet<LogLine['verdict']> = new Set([undefined, 'good']);

export const bytesOf = ({ hex }: LogLine): Uint8Array => fromHex(hex) ?? NONE;

/** The frame that a line is; `undefined` where it is none. */
export function readingOf(line: LogLine, request: Uint8Array | undefined): Reading | undefined {
  if (line.kind === 'noise') return undefined;
  const bytes = bytesOf(line);
  const { transport } = line;
  if (REQUESTS.has(line.kind) || (line.kind === 'heard' && line.direction === 'sent'))
    return decodeFrame(bytes, { transport, direction: 'request' });
  const context: DecodeContext = { transport, direction: 'response', ...(request && { request }) };
  const reading = decodeFrame(bytes, context);
  if (line.kind !== 'heard' || reading.outcome.kind === 'whole') return reading;
  return decodeFrame(bytes, { transport, direction: 'request' });
}

/** What a line means, in a sentence. */
export function meaningOf(line: LogLine): string {
  const reading = readingOf(line, undefined);
  const size = line.hex.length / 2;
  return reading === undefined ? words.log.noMeaning(size) : pageWords.page.summary(reading, size, line.transport);
}

/** Whether something is wrong with what a line stands for. */
export const isTrouble = ({ kind, verdict }: LogLine): boolean =>
  // What is heard while this page listens is the talk of others; else nobody has asked for it.
  kind === 'heard'
    ? verdict !== 'good'
    : !GOOD.has(verdict) || !(REPLIES.has(kind) || REQUESTS.has(kind)) || kind === 'late' || kind === 'exception';

/** The lines that are shown, with a search for bytes or for words of the meaning. */
export function shownLines(log: readonly LogLine[], filter: Filter, search: string): readonly LogLine[] {
  const digits = search.replaceAll(/[\s,]|0x/gi, '').toUpperCase();
  const asBytes = /^[0-9A-F]+$/.test(digits) ? digits : undefined;
  const wanted = search.trim().toLowerCase();
  if (filter === 'all' && wanted === '') return log;
  return log.filter((line) => {
    if (filter === 'troubles' && !isTrouble(line)) return false;
    if (filter === 'frames' && !FRAMES.has(line.kind)) return false;
    if (wanted === '') return true;
    if (asBytes !== undefined && line.hex.includes(asBytes)) return true;
    return `${words.log.kinds[line.kind]} ${meaningOf(line)} ${spacedHex(line.hex)}`.toLowerCase().includes(wanted);
  });
}
