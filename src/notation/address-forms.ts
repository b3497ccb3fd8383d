import { readNumber } from './number.ts';

/** What stands around an address: a bit of it, how many there are, how a text lies in them. */
export interface AddressForm {
  /** The address itself. */
  readonly base: string;
  /** `40001.5`, `40001:5`, `%MW100:X3`: a bit of the register, from 0. */
  readonly bit?: number;
  /** `40001-40002`: the end of a range. */
  readonly last?: string;
  /** `412380.10L`: the registers of a text of 10 characters. */
  readonly quantity?: number;
  /** The low byte of each register has the first character. */
  readonly lowByteFirst?: true;
  /** The other number of `0x1000 (4096)`, which has to be the same address. */
  readonly also?: string;
}

const NUMBER = /^(?:\d+|0x[\da-f]+|[\da-f]+h)$/i;
/** An address that may have a bit: the number that manuals print, one in hexadecimal, one with letters or of IEC 61131. */
const WITH_BIT = /^(?:[0134]\d{4,5}|[0134]x\d+|0x[\da-f]+|(?:IR|HR) ?\d+|%[IQM]W\d+)$/i;
const MOST_BIT = 15;
const RANGE = /^(.*?\w)\s*(?:\.\.\.?|…|[-–—~～〜]|\bto\b|\bbis\b|至)\s*(\w.*)$/i;

/**
 * Takes an address out of what people write around it; `undefined` for a text that is one already, or none. `H1000` is `0x1000`,
 * `4-0001` is `4:0001`, `40 001` and `40,001` are `40001`.
 */
export function addressForm(text: string): AddressForm | undefined {
  const typed = text.trim();
  const [, hex] = /^&?H([\da-f]{1,5})$/i.exec(typed) ?? [];
  if (hex) return { base: `0x${hex}` };
  const [, digit, number] = /^([0134])[- ](\d{4,5})$/.exec(typed) ?? [];
  if (digit) return { base: `${digit}:${number}` };
  if (/^\d{1,3}(?:[\u0020\u00a0\u202f'’,.]\d{3})+$/.test(typed)) return { base: typed.replace(/\D/g, '') };
  const [, first = '', second = ''] = /^(\w+)\s*(?:\(|[=/]\s*)(\w+)\)?$/.exec(typed) ?? [];
  if (NUMBER.test(first) && NUMBER.test(second) && !isBit(typed, first, second)) return { base: first, also: second };
  const [, block, size, order] = /^([0134]\d{4,5})\.(\d{1,3})([HL])$/i.exec(typed) ?? [];
  if (block)
    return {
      base: block,
      quantity: Math.ceil(Number(size) / 2),
      ...(/l/i.test(order ?? '') && { lowByteFirst: true as const }),
    };
  const [, base = '', mark = '', bit = ''] = /^(.+?)(\.|:X?|\/|\s+bit\s*)(\d{1,2})$/i.exec(typed) ?? [];
  if (bit !== '' && Number(bit) <= MOST_BIT && (WITH_BIT.test(base) || (mark !== '.' && /^\d{2,}$/.test(base))))
    return { base, bit: Number(bit) };
  const [, from, last] = RANGE.exec(typed) ?? [];
  return from === undefined || last === undefined ? undefined : { base: from, last };
}

/** Whether a second number behind a slash is a bit: `40001/5`. */
const isBit = (typed: string, first: string, second: string): boolean =>
  typed.includes('/') && WITH_BIT.test(first) && /^\d{1,2}$/.test(second) && Number(second) <= MOST_BIT;

/**
 * The address alone, without what tells a bit or says it twice. A range stays as it is, and so does what has a slash, which parts
 * an address from other numbers too.
 */
export function plainAddress(text: string): string {
  const form = text.includes('/') ? undefined : addressForm(text);
  if (form === undefined || form.last !== undefined) return text;
  return form.also === undefined || readNumber(form.also) === readNumber(form.base) ? form.base : text;
}
