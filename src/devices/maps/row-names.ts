import type { NamedNumber } from '../profile.ts';
import { isFilled } from './cell-kinds.ts';
import type { MapRow } from './map-row.ts';
import { areMasks, type NamesReading } from './names-cell.ts';
import type { RowDoubts } from './row-doubts.ts';

/** The names of the values or bits of a row, and the texts that describe it. */
export interface RowNames {
  readonly names: readonly NamedNumber[];
  /** They are names of bits. */
  readonly bits: boolean;
  readonly description: string;
}

/** Names longer than that are prose with a number in it. */
const MOST_WORDS = 6;
const LONGEST_REST = 60;

/** Reads the names of a row and of the rows below it. What is no name, and ranges, become a part of the description. */
export function namesOfRow(row: MapRow, { notices }: RowDoubts): RowNames {
  const names: NamedNumber[] = [];
  let bits = false;
  const take = (read: NamesReading) => {
    names.push(...numbered(read));
    bits ||= read.bits === true || read.masks === true;
  };
  const name = row.text('name');
  const description = row.texts('description').filter((text) => text !== name);
  const others = row.texts('other-name').filter((text) => isFilled(text) && text.toLowerCase() !== name.toLowerCase());
  if (name !== '') description.push(...others);
  const listed = row.texts('names');
  for (const text of [...listed, row.text('unit')]) {
    const read = row.read.names(text);
    const isNames = read.names.length > 0 && row.read.range(text) === undefined;
    if (isNames) take(read);
    const rest = isNames ? read.rest : listed.includes(text) ? text : '';
    if (rest === '') continue;
    notices.push(row.read.range(rest) !== undefined ? 'range-kept' : 'names-rest');
    description.push(rest);
  }
  for (const text of row.texts('range').filter(isFilled)) {
    const read = row.read.pairs(text);
    if (read.names.length > 0 && row.read.range(text) === undefined) take(read);
    else {
      notices.push('range-kept');
      description.push(text);
    }
  }
  if (names.length === 0) {
    const inText = [...row.texts('description'), name, row.text('type')].map(row.read.pairs).find(isClean);
    if (inText) take(inText);
  }
  const masks = row.parts.length > 0 && areMasks(row.parts.flatMap(({ number }) => number ?? []));
  for (const { number, bit, name: part } of row.parts) {
    if (bit !== undefined) names.push({ number: bit, name: part });
    else if (number !== undefined) names.push({ number: masks ? Math.log2(number) : number, name: part });
  }
  bits ||= masks || row.parts.some(({ bit }) => bit !== undefined);
  if (names.length > 1 && new Set(names.map(({ number }) => number)).size < names.length) notices.push('names-twice');
  return {
    names: names.filter(({ number }) => Number.isSafeInteger(number)),
    bits,
    description: description.join('\n'),
  };
}

/** Whether a text that may be prose lists names and hardly anything else. */
const isClean = ({ names, rest }: NamesReading): boolean =>
  names.length > 1 && rest.length < LONGEST_REST && names.every(({ name }) => name.split(/\s+/).length <= MOST_WORDS);

const numbered = ({ names, masks }: NamesReading): readonly NamedNumber[] =>
  masks ? names.map(({ number, name }) => ({ number: Math.log2(number), name })) : names;

/** The bit that a row is about: `Pump runs [bit 4]`, a column of bits, a mask of one bit. */
export function bitOfRow(row: MapRow): number | undefined {
  const column = /^(?:bit|b)?\s*(\d{1,2})$/i.exec(row.text('bit'))?.[1];
  if (column !== undefined) return Number(column);
  const mask = Math.log2(maskOfRow(row) ?? Number.NaN);
  if (Number.isInteger(mask)) return mask;
  const named = /[[(]\s*bit\s*[:#.]?\s*(\d{1,2})\s*[\])]/i.exec(row.text('name'))?.[1];
  return named === undefined ? undefined : Number(named);
}

const WIDEST = 32;

/** The mask of a row, or of a group of bits (`2-3`); `undefined` if it has neither. */
export function maskOfRow(row: MapRow): number | undefined {
  const [, first, last] = /^(?:bits?|b)?\s*(\d{1,2})\s*[-–.:~]+\s*(\d{1,2})$/i.exec(row.text('bit')) ?? [];
  const { bit = Number(first), lastBit = Number(last) } = row.address;
  if (lastBit !== bit && lastBit < WIDEST && bit < WIDEST)
    return 2 ** (Math.max(bit, lastBit) + 1) - 2 ** Math.min(bit, lastBit);
  const text = row.text('mask');
  const mask = /^(?:0x[\da-f]+|\d+)$/i.test(text) ? Number(text) : 0;
  return mask > 0 && Number.isSafeInteger(mask) ? mask : undefined;
}
