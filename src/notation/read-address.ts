import type { Table } from '../modbus/index.ts';
import { plainAddress, WITH_BIT } from './address-forms.ts';
import { type AddressConvention, type AddressMeaning, plainMeanings } from './address-meanings.ts';
import { readNumber } from './number.ts';
import { plcMeanings } from './plc-devices.ts';

/** What a text says of an address beside the address itself. */
type Beside = Pick<AddressMeaning, 'bit' | 'quantity' | 'lowByteFirst'>;

/** The bit that a text names behind an address: 5 of `40001.5` and `40001/5`; `undefined` if it names none. */
export function bitOfAddress(text: string): number | undefined {
  const [, , bit] = WITH_BIT.exec(plainBit(text.trim()).replace(/\/(?=\d{1,2}$)/, ':')) ?? [];
  return bit === undefined ? undefined : Number(bit);
}

/** `40001.5` of `40001[5]` and `40001.b5`, and `40001.10` of `40001.A`. */
const plainBit = (text: string): string =>
  text
    .replace(/^([^[]*\w)\[(?:bit\s*)?(\w+)\]$/i, '$1.$2')
    .replace(/\.b(?=\d{1,2}$)/i, '.')
    .replace(/(?<=\d\.)[a-f]$/i, (digit) => String(Number.parseInt(digit, 16)));

/** What may stand before an address. */
const CALLED = /^(?:reg(?:ister)?|addr(?:ess)?)\.?\s+(?=\S*\d)/i;

/** Strings of Kepware: `412380.10L` has 10 characters, the first in the low byte; `H` has it in the high one. */
const TEXT = /^([0134]\d{4,5})\.(\d{1,3})([HL])$/i;
const TWICE = /^(\w+)\s*(?:\(|[=/]\s*)(\w+)\)?$/;
const RANGE = /^(.*?\w)\s*(?:\.\.\.?|…|[-–—~～〜]|\bto\b|\bbis\b|至)\s*(\w.*)$/i;

/**
 * Every meaning that a text may have as an address, the likeliest under a convention first. `table` is that of the function
 * it is typed for: plain numbers are of it, and only for coils leading zeros and `0x` may be the digit of the coils. What a
 * text says beside the address is in each: a bit (`40001.5`), how many (`40001-40002`), a text's order (`412380.10L`).
 */
export function readAddress(
  text: string,
  convention: AddressConvention = 'protocol',
  table?: Table,
): readonly AddressMeaning[] {
  const typed = plainBit(text.trim().replace(CALLED, ''));
  const read = (base: string, beside: Beside = {}) =>
    meaningsOf(base, convention, table).map((meaning) => ({ ...meaning, ...beside }));
  const [, block, size, order] = TEXT.exec(typed) ?? [];
  if (block) {
    const isLow = /l/i.test(order ?? '');
    return read(block, { quantity: Math.ceil(Number(size) / 2), ...(isLow && { lowByteFirst: true as const }) });
  }
  const bit = bitOfAddress(typed);
  if (bit !== undefined) return read(plainAddress(typed.replace('/', ':')), { bit });
  const [, first = '', second = ''] = TWICE.exec(typed) ?? [];
  const other = readNumber(second);
  if (other !== undefined) {
    // The printed number may stand behind the address: `0 (40001)`.
    const own = readNumber(first);
    const before = read(first).filter(({ address }) => address === other);
    return before.length > 0
      ? before
      : read(second).filter(({ address, notation }) => address === own && notation !== 'number');
  }
  const plain = plainAddress(typed);
  if (plain === typed && RANGE.test(typed)) return rangeOf(typed, read);
  // Digits that may be grouped are a decimal number too, which a frame's field takes them for.
  const grouped = typed.replace(/[.,](?=\d{3}\b)/g, '');
  return plain === typed && grouped !== typed ? [...read(typed), ...read(grouped)] : read(plain);
}

type Read = (text: string, beside?: Beside) => readonly AddressMeaning[];

function rangeOf(typed: string, read: Read): readonly AddressMeaning[] {
  const [, first = '', last = ''] = RANGE.exec(typed) ?? [];
  const ends = read(endOf(first, last));
  return read(first).flatMap((from) => {
    const to = ends.find((end) => end.notation === from.notation && end.table === from.table);
    return to === undefined || to.address < from.address ? [] : [{ ...from, quantity: to.address - from.address + 1 }];
  });
}

/** The end of a range, of which only the last digits may be there: `40001-02`. */
const endOf = (base: string, last: string): string =>
  /^\d+$/.test(base) && /^\d+$/.test(last) && last.length < base.length && Number(last) < Number(base)
    ? base.slice(0, -last.length) + last
    : last;

/** What stands in a text with nothing around it, and last what it is in controllers. */
const meaningsOf = (
  text: string,
  convention: AddressConvention,
  table: Table | undefined,
): readonly AddressMeaning[] => [
  ...plainMeanings(text, convention, table),
  ...plcMeanings(text).map((meaning) => ({ ...meaning, notation: 'plc' as const })),
];
