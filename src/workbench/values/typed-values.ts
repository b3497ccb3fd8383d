import {
  formatHex,
  type PlacedValue,
  readNumbers,
  readValues,
  type ValueFault,
  type ValuesReading,
  withPoints,
} from '../../notation/index.ts';
import type { Draft } from '../frame/draft.ts';
import type { Control, Evaluation } from '../frame/evaluate.ts';
import { roomOf } from '../frame/form-layout.ts';
import { placeOf, type UnitSource, unitsAt } from './targets.ts';

/** What was typed for a field of registers, read. */
export interface TypedReading extends ValuesReading {
  readonly registers: readonly number[];
  /** The text for the field; `undefined` while something is wrong. */
  readonly text: string | undefined;
  /** Whether they are more registers than the field takes. */
  readonly tooMany: boolean;
}

/** A field of registers, in its form. */
export interface ValueField {
  readonly control: Control;
  readonly draft: Draft;
  readonly evaluation: Evaluation;
}

/** Reads values of any type and unit for a field of registers: `30 Hz`, `f32 CDAB 21.5`. */
export function readTyped(typed: string, { control, draft, evaluation }: ValueField, units: UnitSource): TypedReading {
  const place = placeOf(control, draft, evaluation);
  const { values, faults, notices } = readValues(typed, (behind) => unitsAt(units, place, behind));
  const registers = values.flatMap((value) => value.registers);
  const tooMany = registers.length > roomOf(control, evaluation);
  const ready = registers.length > 0 && faults.length === 0 && !tooMany;
  return { values, faults, notices, registers, tooMany, text: ready ? values.map(textOfValue).join(' ') : undefined };
}

/**
 * The text that the field gets for what was typed: plain numbers as they are, values as their registers. A decimal comma is not one
 * of a list, as it is in the text of a frame.
 */
export function valueInFrame(typed: string, field: ValueField, units: UnitSource): string {
  const { text } = withPoints(typed);
  return readNumbers(text).kind === 'list' ? text : (readTyped(typed, field, units).text ?? text);
}

/** Registers as `0x1000 0x0001`. */
export const registersText = (registers: readonly number[]): string =>
  registers.map((register) => formatHex(register, 4)).join(' ');

/** A single number in a unit stands in the form as the number; all else as the bits it is. */
const textOfValue = ({ registers, notes }: PlacedValue): string => {
  const [only, ...more] = registers;
  const decimal = notes.some(({ code }) => code === 'in-units') && more.length === 0;
  return decimal ? String(only) : registersText(registers);
};

/** Why the text of a field is not a value, beyond what the form itself says of it. */
export type TypedFault =
  | { readonly code: 'fault'; readonly fault: ValueFault }
  | { readonly code: 'too-many'; readonly registers: number }
  /** It is a number with a unit, of which nothing here says what it is in registers. */
  | { readonly code: 'unit'; readonly typed: string; readonly unit: string }
  /** It has become a value since it was typed: its device was chosen after. */
  | { readonly code: 'type-again'; readonly read: TypedReading };

/** What is wrong with a field's text as a value; `undefined` if it is a list of numbers, or only looks like a mistyped one. */
export function typedFault(text: string, field: ValueField, units: UnitSource): TypedFault | undefined {
  if (readNumbers(text).kind === 'list') return undefined;
  const read = readTyped(text, field, units);
  const unit = unitIn(text);
  if (unit !== undefined && read.faults.some(({ fault }) => isUnknown(fault) || isOpen(fault, units)))
    return { code: 'unit', typed: text.trim(), unit };
  const fault = read.faults[0]?.fault;
  if (fault) return isPlain(fault) ? undefined : { code: 'fault', fault };
  if (read.tooMany) return { code: 'too-many', registers: read.registers.length };
  return read.text === undefined ? undefined : { code: 'type-again', read };
}

/** Whether a number or its unit means nothing here. */
const isUnknown = (fault: ValueFault): boolean =>
  fault.code === 'not-a-value' || (fault.code === 'unit-unknown' && fault.known.length === 0);

/** Whether a device may still know the unit, though the person's own scale has another. */
const isOpen = (fault: ValueFault, { device }: UnitSource): boolean =>
  fault.code === 'unit-unknown' && device === undefined;

/** Whether the form says it better: it looks like a mistyped number. */
const isPlain = (fault: ValueFault): boolean => isUnknown(fault) || fault.code === 'name-unknown';

const NUMBER_AND_UNIT = /^\s*[-+]?\d+(?:[.,]\d+)?(\s*)([^\s\d.,;:"'+-][^\s\d,;"']*\d?)\s*$/u;

/** Units of one letter, which need no blank before them. */
const SHORT = new Set(['V', 'W', 'K', 's', 'm', 'g', '%']);

/** The unit of a text that is one number with a unit: `45 Hz`, `45Hz`, `20 %`. A letter behind digits is a slip of the finger, or hexadecimal. */
export function unitIn(text: string): string | undefined {
  const [, blank = '', unit = ''] = NUMBER_AND_UNIT.exec(text) ?? [];
  const glued = SHORT.has(unit) || (unit.length > 1 && !/^[a-f]*\d?$/i.test(unit));
  return unit !== '' && (blank !== '' || glued) ? unit : undefined;
}
