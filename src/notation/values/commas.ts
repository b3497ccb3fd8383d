import type { TextRange } from '../read-bytes/index.ts';

/** A number that may be read in another way, and how each of these is written so that it is read so. */
export interface ValuesNotice {
  readonly code: 'decimal-comma' | 'grouped-digits';
  readonly place: TextRange;
  readonly typed: string;
  /** As it is read. */
  readonly read: string;
  /** The text as a list of two numbers. */
  readonly list?: string;
  /** The text with the digits as one whole number. */
  readonly whole?: string;
}

/** Commas, and the texts in which they mean nothing. */
const COMMAS = /"(?:[^"]|"")*"?|,/g;
const GROUPS = /(?<![\d.,])([-+−]?\d{1,3})([.,])(\d{3})(?![\d.,])/;

/** Digits in groups before a decimal mark that is not the mark of the groups: `1.234,5` and `1,234.5`. */
const GROUPED_DECIMAL = /(?<![\w.,#$])[-+−]?\d{1,3}(?:(?:\.\d{3})+,\d+|(?:,\d{3})+\.\d+)(?![\w.,]*\d|[.,]\d)/g;

/** A text in which decimal commas are points, and what of it may be read otherwise. Its length is the same. */
export interface PlainNumbers {
  readonly text: string;
  readonly notices: readonly ValuesNotice[];
}

/**
 * One comma between two digits is a decimal comma; two or more, and a comma with a blank, make a list. Where semicolons or line
 * ends stand between the values, each of these may have one: `21,5; 22,5`. `1.000` of whole numbers may be a thousand, and
 * `1.234,5` has a comma alone that is decimal.
 */
export function withPoints(typed: string): PlainNumbers {
  if (!typed.includes('"') && typed.search(GROUPED_DECIMAL) >= 0) return withoutGroups(typed);
  const commas = [...typed.matchAll(COMMAS)].filter(([mark]) => mark === ',').map(({ index }) => index);
  if (commas.length === 0) return { text: typed, notices: groupedIn(typed) };
  if (!commas.every((at) => isBetweenDigits(typed, at)) || !(commas.length === 1 || isOneEach(typed)))
    return { text: typed, notices: [] };
  const text = typed.replace(COMMAS, (mark) => (mark === ',' ? '.' : mark));
  const [at = 0] = commas;
  return { text, notices: commas.length === 1 ? [noticeAt(typed, at)] : [] };
}

function withoutGroups(typed: string): PlainNumbers {
  const notices: ValuesNotice[] = [];
  const text = typed.replace(GROUPED_DECIMAL, (number, at: number) => {
    const mark = /[.,](?=\d+$)/.exec(number)?.[0] ?? '';
    const read = number.replace(mark === ',' ? /\./g : /,/g, '').replace(',', '.');
    const list = `${typed.slice(0, at)}${number.replace(',', ', ')}${typed.slice(at + number.length)}`;
    notices.push({
      code: mark === ',' ? 'decimal-comma' : 'grouped-digits',
      place: { start: at, end: at + number.length },
      typed: number,
      read,
      list,
    });
    return read.padEnd(number.length);
  });
  return { text: withPoints(text).text, notices };
}

/** Whole numbers in decimal stand on both sides, the second perhaps with its unit. */
const isBetweenDigits = (text: string, at: number): boolean =>
  /(?<![\w.#$])\d+$/.test(text.slice(0, at)) && /^\d+(?![\d.x#]|h\b|b\d)/i.test(text.slice(at + 1));

/** Whether every part between semicolons has at most one comma, or every line that begins with a type or ends with a unit. */
function isOneEach(text: string): boolean {
  const parts = text.split(/[;\n]/).filter((part) => part.trim() !== '');
  const one = parts.length > 1 && parts.every((part) => (part.match(/,/g) ?? []).length <= 1);
  return one && (text.includes(';') || parts.every((part) => /^\s*[a-z]|[a-z%°µΩ]\S*\s*$/i.test(part)));
}

function noticeAt(typed: string, at: number): ValuesNotice {
  const start = /[-+−\d]*$/.exec(typed.slice(0, at))?.index ?? at;
  const end = at + 1 + (/^\d*/.exec(typed.slice(at + 1))?.[0].length ?? 0);
  const number = typed.slice(start, end);
  const around = (inside: string) => typed.slice(0, start) + inside + typed.slice(end);
  return {
    code: 'decimal-comma',
    place: { start, end },
    typed: number,
    read: number.replace(',', '.'),
    list: around(number.replace(',', ', ')),
    ...(GROUPS.test(number) && { whole: around(number.replace(',', '')) }),
  };
}

/** `1.000` where no type of numbers with a fraction is named. */
function groupedIn(typed: string): readonly ValuesNotice[] {
  const found = GROUPS.exec(typed);
  if (found === null || (found[3] !== '000' && /\b(?:f\d|fl|re|lr|do|si|ha)/i.test(typed))) return [];
  const [number, before = '', , behind = ''] = found;
  const [start, end] = [found.index, found.index + number.length];
  const whole = `${typed.slice(0, start)}${before}${behind}${typed.slice(end)}`;
  return [{ code: 'grouped-digits', place: { start, end }, typed: number, read: String(Number(number)), whole }];
}
