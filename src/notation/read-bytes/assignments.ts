import { Token } from './items.ts';
import type { Line } from './plain-text.ts';
import type { Section } from './sections.ts';

/** Fewest elements that are a frame. */
const LEAST = 3;

const ELEMENT = /([A-Za-z_]\w{0,60})\s{0,3}\[\s{0,3}(\d{1,4})\s{0,3}\]\s{0,3}=(?!=)\s{0,3}([^;\n]{1,100})/g;
const VARIABLE = /([A-Za-z_]\w{0,60})\s{0,8}=\s{0,8}(0x[0-9a-f]{1,8}|\d{1,10})\s{0,4}(?:;|\n|$)/gi;
const CAST = /\((?:byte|char|uint8_t|unsigned char|int|uint16_t|ushort|u8|word)\)/gi;
const HIGH = /^(?:highbyte|hibyte|hi)\((.*)\)$|^(.*?)(?:>>8|\/256)$/i;
const LOW = /^(?:lowbyte|lobyte|lo)\((.*)\)$|^(.*?)(?:&0xff|%256)$/i;

/**
 * Sections with the frame that a program puts together element by element, `message[2] = (byte)(address >> 8);`, in place of
 * the lines that do it. The names have the values that the program gave them.
 */
export function withAssignments(
  plain: string,
  lines: readonly Line[],
  sections: readonly Section[],
): readonly Section[] {
  if (!/\]\s{0,3}=/.test(plain)) return sections;
  const frames = framesOf(plain);
  if (frames.length === 0) return sections;
  const all: Section[] = [];
  let next = 0;
  for (const tokens of frames) {
    const [from, to] = [tokens[0]?.start ?? 0, tokens.at(-1)?.end ?? 0];
    const line = lines.find(({ start, after }) => start <= from && from < after);
    while (next < sections.length && (sections[next] as Section).line.end < from) {
      const section = sections[next++] as Section;
      // The value of a variable that is declared in two lines.
      all.push(section.tokens.length === 1 ? { ...section, certainty: 1 } : section);
    }
    while (next < sections.length && (sections[next] as Section).line.start <= to) next++;
    if (line !== undefined) all.push(sectionOf(tokens, line));
  }
  return [...all, ...sections.slice(next)];
}

const sectionOf = (tokens: readonly Token[], line: Line): Section => ({
  label: {},
  tokens,
  runs: [],
  first: undefined,
  certainty: 3,
  alone: true,
  continued: false,
  hint: undefined,
  mark: '',
  isComment: false,
  line,
});

/** The elements of each frame, from index 0 on, as far as their values are known. */
function framesOf(plain: string): readonly (readonly Token[])[] {
  const values = new Map(Array.from(plain.matchAll(VARIABLE), ([, name = '', value = '']) => [name, Number(value)]));
  const frames: Token[][] = [];
  let array = '';
  let elements: Token[] | undefined;
  for (const { 0: whole, 1: name = '', 2: place = '', 3: text = '', index } of plain.matchAll(ELEMENT)) {
    const value = byteOf(text.trim(), values);
    if (Number(place) === 0) {
      array = name;
      elements = [];
      frames.push(elements);
    }
    if (value === undefined || name !== array || Number(place) !== elements?.length) {
      elements = undefined;
      continue;
    }
    const start = index + whole.length - text.length;
    const token = new Token('number', start, start + text.trimEnd().length, start, start + text.trimEnd().length, 16);
    token.value = value;
    elements.push(token);
  }
  return frames.filter(({ length }) => length >= LEAST);
}

/** The value of a byte as C, C# and Python write it; `undefined` if a name in it is not known. */
function byteOf(text: string, values: ReadonlyMap<string, number>): number | undefined {
  let rest = text.replace(CAST, '').replace(/\s/g, '');
  while (/^\([^()]*\)$/.test(rest)) rest = rest.slice(1, -1);
  if (/^(?:0x[0-9a-f]{1,4}|\d{1,5})$/i.test(rest)) return inByte(Number(rest));
  const low = LOW.exec(rest);
  if (low !== null) return of(low[1] ?? low[2] ?? '', values, (value) => value & 0xff);
  const high = HIGH.exec(rest);
  if (high !== null) return of(high[1] ?? high[2] ?? '', values, (value) => (value >> 8) & 0xff);
  const value = values.get(rest);
  return value === undefined ? undefined : value & 0xff;
}

function of(text: string, values: ReadonlyMap<string, number>, take: (value: number) => number): number | undefined {
  const inner = text.replace(/^\((.*)\)$/, '$1');
  const shifted = HIGH.exec(inner);
  if (shifted !== null && inner !== text)
    return of(shifted[1] ?? shifted[2] ?? '', values, (value) => take(value >> 8));
  const value = values.get(inner);
  return value === undefined ? undefined : take(value);
}

const inByte = (value: number): number | undefined => (value <= 0xff ? value : undefined);
