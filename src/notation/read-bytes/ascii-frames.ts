import { fromHex, lrc } from '../../modbus/index.ts';
import { labelOf } from './label-of.ts';
import type { Output } from './output.ts';
import type { Line } from './plain-text.ts';
import type { ChunkLabel, TextRange } from './types.ts';

/** A frame in ASCII, from its colon on. */
export interface AsciiPiece extends TextRange {
  readonly label: ChunkLabel;
  /** Its checksum holds. */
  readonly isSure: boolean;
  readonly line: Line;
}

const CR = 0x0d;
const LF = 0x0a;

/** A colon that begins a frame rather than ends a label. */
const START = /(?<!\w):(?=[0-9a-f]{6})(?!0b[01]{8}(?!\w))/gi;
const END = /[\s<[{(\\"'`^\u240d\u240a]/;
/** What stands for the two characters at the end of a frame, where a program shows them. */
const ENDS: readonly { readonly form: RegExp; readonly value: number }[] = [
  { form: / ?(?:<CR>|\[CR\]|\{CR\}|\(CR\)|\\r|\\x0d|\\0D|\^M|\u240d|<0x0D>|<0D>|\[0D\]|CR(?=LF|\b))/iy, value: CR },
  { form: / ?(?:<LF>|\[LF\]|\{LF\}|\(LF\)|\\n|\\x0a|\\0A|\^J|\u240a|<0x0A>|<0A>|\[0A\]|LF\b)/iy, value: LF },
];
/** The most blanks at the end of a line behind a frame. */
const MOST_BLANKS = 80;

/** The ASCII frames of a text, in order (SL 2.5.2). */
export function asciiFramesOf(plain: string, lines: readonly Line[]): readonly AsciiPiece[] {
  if (plain.search(START) < 0) return [];
  const pieces: AsciiPiece[] = [];
  for (const line of lines) {
    const text = plain.slice(line.start, line.end);
    if (!text.includes(':')) continue;
    let read = 0;
    for (const { index } of text.matchAll(START)) {
      if (index < read) continue;
      let at = index;
      while (at < text.length && !END.test(text[at] as string)) at++;
      const bytes = fromHex(text.slice(index + 1, at));
      const isSure = bytes !== undefined && bytes.length > 2 && lrc(bytes.subarray(0, -1)) === bytes.at(-1);
      const label = labelOf(text.slice(read, index));
      pieces.push({ start: line.start + index, end: line.start + at, label, isSure, line });
      read = at;
    }
  }
  return pieces;
}

/**
 * Reads an ASCII frame as the codes of its characters. The end of a line of text stands for the frame's own end, CR LF, if
 * the frame shows none.
 */
export function readAsciiFrame(plain: string, { start, end, line }: AsciiPiece, out: Output): void {
  for (let at = start; at < end; at++) {
    const value = plain.charCodeAt(at);
    if (value <= 0xff) out.byte(value, at, at + 1);
    else out.problems.push({ code: 'character-unknown', start: at, end: at + 1 });
  }
  const close = readEnd(plain, end, line.end, out);
  const isLast = line.end - end < MOST_BLANKS && plain.slice(end, line.end).trim() === '';
  if (close === end && isLast) readLineEnd(plain, line, out);
}

/** Reads the marks for CR and LF, each at most once. */
function readEnd(plain: string, from: number, end: number, out: Output): number {
  let at = from;
  for (const { form, value } of ENDS) {
    form.lastIndex = at;
    const mark = form.exec(plain)?.[0];
    if (mark === undefined || at + mark.length > end) continue;
    out.byte(value, at + mark.length - mark.trimStart().length, at + mark.length);
    at += mark.length;
  }
  return at;
}

/** A line feed alone is how the text ends its lines, not what was on the wire. */
function readLineEnd(plain: string, { after, end }: Line, out: Output): void {
  let begin = end;
  while (begin < after && !/[\r\n]/.test(plain[begin] as string)) begin++;
  if (begin === after) return;
  const hasReturn = plain.charCodeAt(begin) === CR;
  out.byte(CR, begin, hasReturn ? begin + 1 : after);
  if (!hasReturn || after - begin === 2) out.byte(LF, hasReturn ? begin + 1 : begin, after);
}
