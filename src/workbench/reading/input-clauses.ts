import type { EntityTable } from '../../devices/index.ts';
import { describeFunction, type FunctionCode, functionCodes } from '../../modbus/index.ts';
import { readNumber } from '../../notation/index.ts';

/** What the words of a request say in any order, and what is left of the text: places, quantities and values. */
export interface Clauses {
  /** As typed. */
  readonly unit: string | undefined;
  /** The function that was named by its code. */
  readonly code: FunctionCode | undefined;
  readonly does: 'read' | 'write' | undefined;
  /** The table that a word such as `coils` names. */
  readonly table: EntityTable | undefined;
  readonly rest: string;
}

const UNIT =
  /(?:^|[\s,;])(?:(?:at|on|from|to|of|for|with)\s+)?(?:(?:unit|slave|station|server|device|node)(?:\s*(?:id|no\.?|number|address|#))?|id)\s*[:=#]?\s*(\d{1,3}|0x[\da-f]{1,2})(?![\w.])/i;
const FUNCTION =
  /(?:^|[\s,;])(?:function|func|fn|fc)(?:\s*(?:code|no\.?|#))?\s*[:=#]?\s*(0x[\da-f]{1,2}|[\da-f]{1,2}h|\d{1,2}|[\da-f]{2})(?![\w.])/i;
const VERB = /^(?:please\s+)?(read|get|poll|write|set|force|preset)\b\s*/i;
/** A number in front of the verb is the unit. */
const UNIT_BEFORE = /^(\d{1,3}|0x[\da-f]{1,2})\s*[:,]?\s+(?=(?:read|get|poll|write|set|force|preset)\b)/i;
const EDGES = /^[\s,;:]+|[\s,;:]+$/g;

/** A word for the elements of a table, as a pattern without anchors that captures two groups. */
export const NOUN = String.raw`(?:(?:the|single|multiple)\s+)*(?:(holding|input|discrete)\s+)?(registers?|regs?|words?|values?|coils?|inputs?|bits?)\b`;

/** A text without the words for the unit, and the unit. */
export function withoutUnit(text: string): { readonly unit: string | undefined; readonly text: string } {
  const found = UNIT.exec(text);
  if (found === null) return { unit: undefined, text };
  return { unit: found[1], text: `${text.slice(0, found.index)} ${text.slice(found.index + found[0].length)}`.trim() };
}

/** Finds what the words of a text say. */
export function clausesOf(text: string): Clauses {
  let rest = text.trim();
  const take = (pattern: RegExp): string | undefined => {
    const found = pattern.exec(rest);
    if (found === null) return undefined;
    rest = `${rest.slice(0, found.index)} ${rest.slice(found.index + found[0].length)}`.replace(EDGES, '');
    return found[1];
  };
  const unit = take(UNIT) ?? take(UNIT_BEFORE);
  const code = functionOf(take(FUNCTION));
  const verb = take(VERB);
  const does = verb === undefined ? undefined : /^(?:read|get|poll)/i.test(verb) ? 'read' : 'write';
  const [all, kind, noun] = new RegExp(`^${NOUN}\\s*(?=[\\d\\s])`, 'i').exec(rest) ?? [];
  // What a single element is called belongs to its number: `register 108`.
  const isPlural = noun?.endsWith('s');
  if (all !== undefined && isPlural) rest = rest.slice(all.length).replace(EDGES, '');
  return { unit, code, does, table: isPlural ? tableNamed(kind, noun) : undefined, rest };
}

/** The function of a code in decimal, or else in hexadecimal. */
export function functionOf(typed: string | undefined): FunctionCode | undefined {
  if (typed === undefined) return undefined;
  const known = (code: number | undefined) => functionCodes.find((each) => each.code === code);
  return known(readNumber(typed)) ?? known(Number.parseInt(typed, 16));
}

/** The table whose elements are called so; `undefined` if those of several are. */
export function tableNamed(kind: string | undefined, noun: string | undefined): EntityTable | undefined {
  const name = noun?.toLowerCase() ?? '';
  const of = kind?.toLowerCase();
  if (name.startsWith('coil') || (name.startsWith('bit') && of === undefined)) return 'coil';
  if (name.startsWith('input') || of === 'discrete') return 'discrete-input';
  return of === 'input' ? 'input-register' : of === 'holding' ? 'holding-register' : undefined;
}

/** The table that a function reads or writes, and which of both it does; `undefined` for a function that does neither, or both. */
export function accessOfCode({ code }: FunctionCode) {
  const { table, access, items } = describeFunction(code, 'request');
  if (table === undefined || table === 'file-record') return undefined;
  if (access !== 'reads' && access !== 'writes') return undefined;
  return items === undefined ? undefined : ({ table, does: access === 'reads' ? 'read' : 'write', items } as const);
}
