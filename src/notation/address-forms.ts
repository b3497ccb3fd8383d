import { readNumber } from './number.ts';

/** An address that may have a bit behind it: `40001.5`, `HR108.5`, `0x6B.5`, `%MW100:X3`, and of any number `100:5`. */
export const WITH_BIT =
  /^([0134]\d{4,5}|[0134]x\d+|0x[\da-f]+|[IH]R ?\d+|%[IQM]W\d+|\d\d+(?!\.))(?:\.|:X?|\s+bit\s*)(\d|0\d|1[0-5])$/i;

/** Digits that blanks, commas or points group: `40 001`. */
const GROUPED = /^\d{1,3}(?:[\s'’,.]\d{3})+$/;

/**
 * An address without what people write around it: `0x1000` of `H1000` and of `0x1000 (4096)`, `4:0001` of `4-0001`, `40001` of
 * `40 001` and of `40001.5`. Any other text stays as it is.
 */
export function plainAddress(text: string): string {
  const typed = text.trim();
  const [, first, second = ''] = /^(\w+)\s*\((\w+)\)$/.exec(typed) ?? [];
  if (first) return readNumber(first) === readNumber(second) ? first : text;
  // `1.000` is a number already, if a strange one.
  if (GROUPED.test(typed)) return Number.isInteger(readNumber(typed)) ? text : typed.replace(/\D/g, '');
  return typed
    .replace(/^&?H([\da-f]{1,5})$/i, '0x$1')
    .replace(/^([0134])[- ](\d{4,5})$/, '$1:$2')
    .replace(WITH_BIT, '$1');
}
