import {
  formatHex,
  type PlacedValue,
  readNumbers,
  readValues,
  type ValueFault,
  type ValuesReading,
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
  const { values, faults } = readValues(typed, (behind) => unitsAt(units, place, behind));
  const registers = values.flatMap((value) => value.registers);
  const tooMany = registers.length > roomOf(control, evaluation);
  const ready = registers.length > 0 && faults.length === 0 && !tooMany;
  return { values, faults, registers, tooMany, text: ready ? values.map(textOfValue).join(' ') : undefined };
}

/** The text that the field gets for what was typed: plain numbers as they are, values as their registers. */
export const valueInFrame = (typed: string, field: ValueField, units: UnitSource): string =>
  readNumbers(typed).kind === 'list' ? typed : (readTyped(typed, field, units).text ?? typed);

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
  /** It has become a value since it was typed: its device was chosen after. */
  | { readonly code: 'type-again'; readonly read: TypedReading };

/** What is wrong with a field's text as a value; `undefined` if it is a list of numbers, or only looks like a mistyped one. */
export function typedFault(text: string, field: ValueField, units: UnitSource): TypedFault | undefined {
  if (readNumbers(text).kind === 'list') return undefined;
  const read = readTyped(text, field, units);
  const fault = read.faults[0]?.fault;
  if (fault) return isPlain(fault) ? undefined : { code: 'fault', fault };
  if (read.tooMany) return { code: 'too-many', registers: read.registers.length };
  return read.text === undefined ? undefined : { code: 'type-again', read };
}

/** Whether the form says it better: it looks like a mistyped number. */
const isPlain = (fault: ValueFault): boolean =>
  fault.code === 'not-a-value' ||
  fault.code === 'name-unknown' ||
  (fault.code === 'unit-unknown' && fault.known.length === 0);
