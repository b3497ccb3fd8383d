import type { NamedNumber } from '../profile.ts';

/** The names of values or bits that a text lists. */
export interface NamesReading {
  readonly names: readonly NamedNumber[];
  /** What of the text is no pair of number and name. */
  readonly rest: string;
  /** The numbers are those of bits: `bit 0: fault`, `b3=run`. */
  readonly bits?: true;
  /** The numbers are masks: 1, 2, 4, 8 … */
  readonly masks?: true;
}

/** A number at the beginning of a pair: `0`, `0x10`, `10h`, `bit 3`, `B3`, `-1`, `Bit0`. A range `3-7` stands for its first number. */
const KEY = String.raw`(?:(?:bits?|b|d(?=\d{1,2}\b)|位)[\s#.:]*)?(?:0x[\da-f]{1,16}|[\da-f]{1,8}h\b|[-−]?\d{1,20})`;
const SIGN = String.raw`\s*(?:=+>?|:|：|->|→|–|—|-{1,3}|\.\.\.|\)|≙|\|)\s*`;
const START = new RegExp(
  String.raw`(?:^|[\s,;；，、/|([{"'·•\n\r。.])(?:["'])?(${KEY})(?:["'])?(?:\s*(?:-|–|~|\.\.+|to)\s*(?:\d+))?(${SIGN})`,
  'giu',
);

/** Longer cells are prose. */
const LONGEST = 10_000;
/** The name-first form is looked for in short texts only. */
const LONGEST_NAME_FIRST = 500;

/** Reads `0=Off; 1=On`, `0: Off, 1: On`, `0-Off 1-On`, lines, hexadecimal keys, `bit 0 = fault`, `{"0":"Off"}`, and `Off 0, On 1`. */
export function readNamesCell(text: string): NamesReading {
  const pairs = readPairs(text);
  return pairs.names.length > 0 ? pairs : (numberFirst(text) ?? nameFirst(text));
}

/** `readNamesCell` without the form that has the name first, which prose has too. */
export function readPairs(text: string): NamesReading {
  if (text.length > LONGEST || !/[\da-f]h?["']?\s*(?:=|:|：|-|–|—|→|≙|\||\.\.\.|\))/iu.test(text))
    return { names: [], rest: text.trim() };
  const plain = text.replace(/\\([\\;])/g, (_, kept: string) => (kept === ';' ? '\u0001' : '\u0002'));
  const starts = [...plain.matchAll(START)].filter(({ 1: key = '', 2: sign = '', index }) =>
    isStart(plain, key, sign, index),
  );
  if (starts.length === 0) return { names: [], rest: text.trim() };
  const names: NamedNumber[] = [];
  const rest: string[] = [];
  let bits = 0;
  const before = plain
    .slice(0, (starts[0] as RegExpExecArray).index)
    .replace(/[\s,;:({["'=]+$/g, '')
    .trim();
  if (before !== '') rest.push(before);
  const bySemicolons =
    starts.length > 1 &&
    starts.slice(1).every(({ index }) => /[;；\n\r]\s*$/u.test(plain.slice(Math.max(0, index - 3), index + 1)));
  for (const [place, start] of starts.entries()) {
    const [whole, key = ''] = start;
    const end = starts[place + 1]?.index ?? plain.length;
    const [name, left] = cut(
      plain.slice(start.index + whole.length, end),
      place < starts.length - 1 ? undefined : bySemicolons ? /[;；\n\r]/u : /[;；\n\r]|,(?=\s)/u,
    );
    if (left !== '') rest.push(left);
    if (/^(?:bits?|b|d|位)/i.test(key)) bits++;
    if (name === '') rest.push(whole.trim());
    else names.push({ number: keyNumber(key), name: name.replaceAll('\u0001', ';').replaceAll('\u0002', '\\') });
  }
  const numbers = names.map(({ number }) => number);
  const masks = areMasks(numbers, /mask|maske|masque|m[aá]scara|maschera|掩码/i.test(rest[0] ?? ''));
  return {
    names,
    rest: rest.join(' ').replaceAll('\u0001', ';').replaceAll('\u0002', '\\'),
    ...(bits > 0 && bits === starts.length ? { bits: true } : {}),
    ...(masks ? { masks: true } : {}),
  };
}

/** Whether numbers are 1, 2, 4, 8 …: four of them with 4 and without 3, or any if a text calls them masks. */
export function areMasks(numbers: readonly number[], called = false): boolean {
  const isMask = (number: number) => number > 0 && Number.isInteger(Math.log2(number));
  const seen = new Set(numbers);
  return numbers.every(isMask) && numbers.length > 0 && (called || (numbers.length > 3 && seen.has(4) && !seen.has(3)));
}

/** A hyphen between two digits is a range, and a point or a colon between them a number or a time: `0-100`, `12:30`. */
function isStart(text: string, key: string, sign: string, index: number): boolean {
  const behind = text
    .slice(index)
    .replace(/^[\s,;；，、/|([{"'·•。.]+/u, '')
    .slice(key.length + sign.length);
  const tight = /^\s*(?:-|–|—|:|\.\.\.|\))\s*$/.test(sign);
  return behind !== '' && !(tight && /^["']?\s*[-−.]?\d/.test(behind)) && !/^[\s,;]*$/.test(behind);
}

function keyNumber(key: string): number {
  const digits = key.replace(/^(?:bits?|b|d(?=\d{1,2}$)|位)[\s#.:]*/i, '').replace('−', '-');
  if (/^0x/i.test(digits)) return Number.parseInt(digits, 16);
  return /h$/i.test(digits) ? Number.parseInt(digits, 16) : Number.parseInt(digits, 10);
}

/** A name without the separator behind it; of the last name, what follows one of these separators is no part of it. */
function cut(text: string, separator: RegExp | undefined): readonly [string, string] {
  const tidy = (part: string) =>
    part
      .replace(/^[\s"'=]+|[\s,;；，、/|"'}\]]+$/gu, '')
      .replace(/^\(([^()]*)$/, '$1')
      .replace(/^([^()]*)\)$/, '$1')
      .trim();
  if (!separator) return [tidy(text), ''];
  const [first = '', ...others] = text.split(separator);
  return [tidy(first), tidy(others.join(' '))];
}

/** `0 Off; 1 On`, without a sign between. */
function numberFirst(text: string): NamesReading | undefined {
  const parts = text
    .split(/[;；,，|\n\r]+/)
    .map((part) => /^\s*(0x[\da-f]{1,8}|\d{1,6})\s+(\p{L}.*?)\s*$/iu.exec(part));
  if (parts.length < 2 || !parts.every((part) => part !== null)) return undefined;
  return { names: parts.map(([, key = '', name = '']) => ({ number: Number(key), name })), rest: '' };
}

/** `Off 0, On 1`, and `STANDBY MODE 1 COOLING MODE 2`. */
function nameFirst(text: string): NamesReading {
  if (text.length > LONGEST_NAME_FIRST || !/\d/.test(text)) return { names: [], rest: text.trim() };
  const found = [
    ...text.matchAll(
      /([^\d,;=:]*[\p{L})][^\d,;=:]*?)\s*[=:]?\s*\(?(0x[\da-f]+|\d+)\)?\s*(?:[,;/\n]|$|\s(?=\p{Lu}))/giu,
    ),
  ];
  const covered = found.reduce((sum, [whole]) => sum + whole.length, 0);
  if (found.length < 2 || covered < text.trim().length * 0.9) return { names: [], rest: text.trim() };
  return { names: found.map(([, name = '', key = '']) => ({ number: Number(key), name: name.trim() })), rest: '' };
}
