import { labelOf } from './labels.ts';
import type { Output } from './output.ts';
import { eachLine } from './plain-text.ts';
import { textColumn } from './text-column.ts';

const CR = 0x0d;
const LF = 0x0a;

/** A colon that begins a frame rather than ends a label. */
const START = /(?<!\w):(?=[0-9a-f]{6})/gi;
/** What stands for the two characters at the end of a frame, where a program shows them. */
const ENDS: readonly { readonly form: RegExp; readonly value: number }[] = [
  { form: / ?(?:<CR>|\[CR\]|\{CR\}|\(CR\)|\\r|\\x0d|\\0D|\^M|\u240d|<0x0D>|<0D>|\[0D\]|CR(?=LF|\b))/iy, value: CR },
  { form: / ?(?:<LF>|\[LF\]|\{LF\}|\(LF\)|\\n|\\x0a|\\0A|\^J|\u240a|<0x0A>|<0A>|\[0A\]|LF\b)/iy, value: LF },
];

/** Whether an ASCII frame begins somewhere in the text. */
export function hasAsciiFrames(plain: string): boolean {
  return plain.search(START) >= 0;
}

/**
 * Reads ASCII frames as the codes of their characters (SL 2.5.2). The end of a line of text stands for the frame's own
 * end, CR LF, if the frame shows none.
 */
export function readAsciiFrames(plain: string, out: Output): void {
  eachLine(plain, (start, end, after) => {
    const whole = plain.slice(start, end);
    const line = whole.slice(0, textColumn(whole));
    let read = 0;
    for (const { index } of line.matchAll(START)) {
      if (index < read) continue;
      const from = out.length;
      let at = index;
      while (at < line.length && !/[\s<[{(\\"'`^\u240d\u240a]/.test(line[at] as string)) {
        readCharacter(line, at, start, out);
        at++;
      }
      const close = readEnd(line, at, start, out);
      if (close === at && line.slice(at, at + 80).trim() === '' && line.length - at < 80) {
        readLineEnd(plain, end, after, out);
      }
      out.chunk(from, labelOf(line.slice(read, index)));
      read = Math.max(close, index + 1);
    }
  });
}

function readCharacter(line: string, at: number, base: number, out: Output): void {
  const value = line.charCodeAt(at);
  if (value <= 0xff) out.byte(value, base + at, base + at + 1);
  else out.problems.push({ code: 'character-unknown', start: base + at, end: base + at + 1 });
}

/** Reads the marks for CR and LF, each at most once. */
function readEnd(line: string, from: number, base: number, out: Output): number {
  let at = from;
  for (const { form, value } of ENDS) {
    form.lastIndex = at;
    const mark = form.exec(line)?.[0];
    if (mark === undefined) continue;
    const end = at + mark.length;
    out.byte(value, base + end - mark.trimStart().length, base + end);
    at = end;
  }
  return at;
}

/** A line feed alone is how the text ends its lines, not what was on the wire. */
function readLineEnd(plain: string, end: number, after: number, out: Output): void {
  if (after === end) return;
  const hasReturn = plain.charCodeAt(end) === CR;
  out.byte(CR, end, hasReturn ? end + 1 : after);
  if (!hasReturn || after - end === 2) out.byte(LF, hasReturn ? end + 1 : end, after);
}
