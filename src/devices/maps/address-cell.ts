import { plcMeanings, readNumber } from '../../notation/index.ts';
import type { EntityTable } from '../profile.ts';
import { digitTables } from './cell-words.ts';

/** How all cells of a column of addresses are written, where one cell alone does not tell. */
export interface AddressStyle {
  /** Hexadecimal without a prefix. */
  readonly hex?: boolean;
  /** `1.000` is one thousand. */
  readonly grouped?: boolean;
  /** `0x00003` is the third coil, as `4x00003` is the third holding register. */
  readonly modicon?: boolean;
  /** Names of devices inside a controller, such as `D100`, are addresses. */
  readonly plc?: boolean;
  /** `4x0000` is in use, so that these numbers count from 0. */
  readonly fromZero?: boolean;
}

/** An address as a cell has it. */
export interface AddressCell {
  /** The number that stands there. */
  readonly number: number;
  /** Its digits if it is decimal: `00001` has five. */
  readonly digits?: string;
  /** The table that its letters or its prefix name, and whether these count from 0 or from 1: `HR1` is mostly the first one. */
  readonly table?: EntityTable;
  readonly counted?: 'zero' | 'one' | 'mostly-one';
  /** It is the name of a device inside a controller, whose family tells the address. */
  readonly device?: string;
  /** The last number of a range or list. */
  readonly last?: number;
  readonly bit?: number;
  /** The last bit of a group of bits. */
  readonly lastBit?: number;
  /** A text begins there, with the high or the low byte of each register first: `412380.10L` has 10 characters. */
  readonly text?: 'high' | 'low';
  /** The other number of `40001 (0)`. */
  readonly also?: number;
}

const LETTERS: ReadonlyMap<string, EntityTable> = new Map([
  ['CO', 'coil'],
  ['DI', 'discrete-input'],
  ['IR', 'input-register'],
  ['HR', 'holding-register'],
  ['MW', 'holding-register'],
  ['QW', 'holding-register'],
  ['IW', 'input-register'],
  ['M', 'coil'],
  ['Q', 'coil'],
  ['I', 'discrete-input'],
]);

const RANGE =
  /^(.*?[\da-fA-F])h?\s*(?:-|–|—|−|~|～|…|\.\.+|\bto\b|\bbis\b|\btot\b|\bdo\b|至|到|÷)\s*(.*\d.*|[\da-fA-F]{2,8}h?)$/iu;

/** One number without a range: `0x64`, `100`, `4x0001`, `HR1`, `%MW100`. */
function readOne(text: string, { hex, grouped, modicon, fromZero, plc }: AddressStyle): AddressCell | undefined {
  const plain = text.trim();
  if (/^\d+$/.test(plain) && !hex) return { number: Number(plain), digits: plain };
  const lettered = /^(CO|DI|IR|HR)[\s:.-]?(\d+)$/i.exec(plain) ?? /^%([IQM]W?)(\d+)$/i.exec(plain);
  if (plc && !lettered && plcMeanings(plain).length > 0)
    return { number: Number(/\d+$/.exec(plain)?.[0]), device: plain, counted: 'zero' };
  if (hex && /^[\da-f]+$/i.test(plain)) return { number: Number.parseInt(plain, 16) };
  const prefixed = /^(?:([0134])[xX](?=\d{1,5}$)(?!\d{0,3}[a-f])|([0134])[:-]\s?(?=\d{4,5}$))(\d+)$/.exec(plain);
  if (prefixed && (modicon || !/^0x/i.test(plain)))
    return {
      number: Number(prefixed[3]),
      table: digitTables.get(prefixed[1] ?? prefixed[2] ?? '') as EntityTable,
      counted: fromZero ? 'zero' : 'one',
    };
  if (lettered)
    return {
      ...(plain.startsWith('%') && { device: plain }),
      number: Number(lettered[2]),
      table: LETTERS.get((lettered[1] as string).toUpperCase()) as EntityTable,
      counted: plain.startsWith('%') ? 'zero' : 'mostly-one',
    };
  const based = /^(?:&H|#x|H'?|x|X'?)([\da-f]{1,8})'?$/i.exec(plain);
  if (based) return { number: Number.parseInt(based[1] as string, 16) };
  if (/^0x[\da-f]+(?:[\s_][\da-f]+)*$/i.test(plain))
    return { number: Number.parseInt(plain.replace(/[\s_]/g, '').slice(2), 16) };
  const value = readNumber(plain);
  if (value !== undefined && Number.isInteger(value) && !/\./.test(plain))
    return value < 0 ? undefined : { number: value };
  // Digits that blanks, commas or points group.
  if (
    /^\d{1,3}(?:[\s\u00a0'’]\d{3})+$/.test(plain) ||
    (grouped && /^\d{1,3}(?:[.,]\d{3})+$/.test(plain)) ||
    /^\d{1,3},\d{3}$/.test(plain)
  ) {
    const digits = plain.replace(/\D/g, '');
    return { number: Number(digits), digits };
  }
  if (/^\d\s\d{4,5}$/.test(plain))
    return { number: Number(plain.replace(/\s/g, '')), digits: plain.replace(/\s/g, '') };
  // A number that a spreadsheet shows with a decimal, and one with a mark of a footnote.
  const trimmed = /^(\d+)(?:[.,]0)?\s*[*+)¹²³†‡°]*$/.exec(plain);
  return trimmed && /[*+)¹²³†‡]$/.test(plain)
    ? { number: Number(trimmed[1]), digits: trimmed[1] as string }
    : undefined;
}

/** `40001.5`, `40001:5`, `40001/5`, `40001 bit 5`, `%MW100:X3`, `40001[3]`, `40001.0-3`. */
const BIT =
  /^(.*[\da-fA-F]h?)(?:\s*[.:/]\s*(?:bit|b|x)?\s*|\s*[,;(]?\s*(?:bits?|b|位)\s*[.:]?\s*|\s*\[\s*(?:bit\s*)?)(\d{1,2}|[a-fA-F])(?:\s*(?:-|–|\.\.+|~|to|…)\s*(?:bit|b)?\s*(\d{1,2}))?\s*[\])]?$/iu;

const bitOf = (text: string): number => (/^\d+$/.test(text) ? Number(text) : Number.parseInt(text, 16));
const MOST_BIT = 63;

/** Reads one cell of a column of addresses; `undefined` if it holds no address. */
export function readAddressCell(text: string, style: AddressStyle = {}): AddressCell | undefined {
  const plain = text
    .replace(/^\s*['"`]|['"`]\s*$/g, '')
    .replace(/^(?:reg(?:ister)?|addr(?:ess)?)\b\.?\s*/i, '')
    .replace(/[\u00a0\s]+/g, ' ')
    .trim();
  if (plain === '' || plain.length > 60 || !/[\da-f]/i.test(plain)) return undefined;
  const one = readOne(plain, style);
  if (one) return one;
  const string = /^(\d{5,6})\.(\d{1,3})([HL])$/i.exec(plain);
  if (string) {
    const number = Number(string[1]);
    const last = number + Math.max(1, Math.ceil(Number(string[2]) / 2)) - 1;
    return { number, digits: string[1] as string, last, text: /l/i.test(string[3] as string) ? 'low' : 'high' };
  }
  const both = /^([^()[\]]+?)\s*[([/=]\s*([^()[\]]+?)\s*[)\]]?$/.exec(plain);
  if (both && (/[([=]/.test(plain) || /0x|h\b/i.test(plain))) {
    const first = readOne(both[1] as string, style);
    const second = readOne(both[2] as string, style);
    if (first && second) {
      if (first.number === second.number) return first.digits === undefined ? second : first;
      if (second.number > 15 || /0x/i.test(both[2] as string)) return { ...first, also: second.number };
    }
  }
  if (!(style.grouped && /^\d{1,3}[.,]\d{3}$/.test(plain))) {
    const bit = BIT.exec(plain);
    const base = bit && readOne(bit[1] as string, style);
    const number = bit && bitOf(bit[2] as string);
    if (bit && base && typeof number === 'number' && number <= MOST_BIT && !(/\//.test(plain) && base.number < 16))
      return { ...base, bit: number, ...(bit[3] === undefined ? {} : { lastBit: Number(bit[3]) }) };
  }
  const range = RANGE.exec(plain);
  if (range) return rangeOf(range[1] as string, range[2] as string, style);
  const list = plain.split(/\s*[,;/&+\n]\s*|\s+(?:and|und|et|y|e|en|i)?\s*/iu).filter((part) => part !== '');
  if (list.length > 1 && list.length <= 8) {
    const cells = list.map((part) => readOne(part, style));
    const [first] = cells;
    const follows = first && cells.every((cell, place) => cell?.number === first.number + place);
    if (first && follows) return { ...first, last: first.number + cells.length - 1 };
  }
  return undefined;
}

/** `40001-40002`, and `40001-02`, whose end has its last digits only. */
function rangeOf(from: string, to: string, style: AddressStyle): AddressCell | undefined {
  const first = readOne(from, style);
  const short = first?.digits !== undefined && /^\d+$/.test(to) && to.length < first.digits.length;
  const last = readOne(short ? `${first.digits.slice(0, -to.length)}${to}` : to, style);
  return first && last && last.number >= first.number && last.number - first.number <= 0xffff
    ? { ...first, last: last.number }
    : undefined;
}
