import { hexDigits } from '../../modbus/index.ts';
import { findFunctions } from '../frame/find-functions.ts';
import type { FoundFunction } from '../frame/functions-by-use.ts';

/** A function by its code and that of a part of it: `43/14`, `2B/0E`. */
const CODE_AND_PART = /^\s*((?:0x)?[\da-f]{1,2}h?)\s*\/\s*((?:0x)?[\da-f]{1,4}h?)\s*$/i;
export const isCodeAndPart = (text: string): boolean => CODE_AND_PART.test(text);

/**
 * The functions that a text names, those first that are used most: by a code behind `function` or `fc`, by a code and that of a
 * part (`2B/0E`), or by words of their names, of which one has three letters at least.
 */
export function functionsNamed(text: string): readonly FoundFunction[] {
  const [, code] = /^\s*(?:function|func|fn|fc)\s*(?:code)?\s*:?\s*((?:0x)?[\da-f]+h?)\s*$/i.exec(text) ?? [];
  if (code !== undefined) return findFunctions(code).slice(0, 1);
  const [, whole, part] = CODE_AND_PART.exec(text) ?? [];
  if (whole !== undefined) return findFunctions(`${whole}/${part}`);
  return /(?:^|\s)[a-z]{3,}(?:\s|$)/i.test(text) ? findFunctions(text) : [];
}

/** The function of a code, the one used most of those that share it. */
export const functionNumbered = (code: number): FoundFunction | undefined =>
  findFunctions(`0x${hexDigits(code, 2)}`)[0];

/** The function whose MEI types are as good as functions. */
const MEI = 0x2b;
/** Functions of one code. */
const MOST = 4;

/** The functions of one code, in decimal and in hexadecimal, or of a code and its sub-function. */
export function functionsOf([first = '', second]: readonly string[]): readonly FoundFunction[] {
  const named = second === undefined ? [] : findFunctions(`${first}/${second}`);
  const codes = [Number(first), Number.parseInt(first, 16)];
  const meant = findFunctions(first).filter(
    ({ code, part }) => codes.includes(code) && (part === undefined || code === MEI),
  );
  return named.length > 0 ? named : meant.slice(0, MOST);
}
