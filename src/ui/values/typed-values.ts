import {
  formatHex,
  type PlacedValue,
  readNumbers,
  readValues,
  type ValueFault,
  type ValuesReading,
} from '../../notation/index.ts';
import type { Control, Draft } from '../../workbench/index.ts';
import { evaluation } from '../state.ts';
import { takeTyped, typedText } from '../typed-texts.ts';
import { valueWords as words } from './language.ts';
import { placeOf, roomOf, unitsAt } from './targets.ts';
import type { ValueAid } from './value-aid.ts';

/** Registers shown before they are put into the frame. */
const SHOWN = 16;

/** What was typed for a field of registers, read. */
export interface TypedReading extends ValuesReading {
  readonly registers: readonly number[];
  /** The text for the field; `undefined` while something is wrong. */
  readonly text: string | undefined;
  /** Whether they are more registers than the field takes. */
  readonly tooMany: boolean;
}

/** Reads values of any type and unit for a field of registers. */
export function readTyped(typed: string, control: Control, draft: Draft): TypedReading {
  const place = placeOf(control, draft, evaluation.value);
  const { values, faults } = readValues(typed, (behind) => unitsAt(place, behind));
  const registers = values.flatMap((value) => value.registers);
  const tooMany = registers.length > roomOf(control, evaluation.value);
  const ready = registers.length > 0 && faults.length === 0 && !tooMany;
  return { values, faults, registers, tooMany, text: ready ? values.map(textOfValue).join(' ') : undefined };
}

export const hexOf = (registers: readonly number[]): string =>
  registers.map((register) => formatHex(register, 4)).join(' ');

/** A single number in a unit stands in the form as the number; all else as the bits it is. */
const textOfValue = ({ registers, notes }: PlacedValue): string => {
  const [only, ...more] = registers;
  const decimal = notes.some(({ code }) => code === 'in-units') && more.length === 0;
  return decimal ? String(only) : hexOf(registers);
};

/** The registers of typed values. */
export const registersSaid = (registers: readonly number[]): string =>
  `${words.registers(registers.length)} ${hexOf(registers.slice(0, SHOWN))}${registers.length > SHOWN ? ' …' : ''}`;

/** What values come to: their notes, and their registers where the notes do not say them. */
function saidOf({ values, registers }: TypedReading): string {
  const notes = values.slice(0, SHOWN).flatMap((value) => value.notes.map(words.note));
  return values.length === 1 && values[0]?.notes[0]?.code === 'in-units'
    ? notes.join(' ')
    : [...notes, registersSaid(registers)].join(' ');
}

/** Whether the form says it better: it looks like a number that is none. */
const isPlain = (fault: ValueFault): boolean =>
  fault.code === 'not-a-value' ||
  fault.code === 'name-unknown' ||
  (fault.code === 'unit-unknown' && fault.known.length === 0);

/** Lets values be typed into a field of registers as they are: `30 Hz`, `f32 CDAB 21.5`. */
export function typedValues(control: Control, draft: Draft, onText: (text: string) => void): ValueAid | undefined {
  const { path, text } = control;
  if (roomOf(control, evaluation.value) === 0) return undefined;
  const inFrame = (typed: string) =>
    readNumbers(typed).kind === 'list' ? typed : (readTyped(typed, control, draft).text ?? typed);
  const typed = typedText(path, text, inFrame);
  return {
    typed: { text: typed ?? text, onText: (next) => onText(takeTyped(path, next, inFrame)) },
    said: typed === undefined ? undefined : saidOf(readTyped(typed, control, draft)),
    wrong: readNumbers(text).kind === 'wrong' ? wrongOf(readTyped(text, control, draft)) : undefined,
  };
}

/** Why a text of the form is no value; where it has become one since it was typed, what it would be. */
function wrongOf(read: TypedReading): string | undefined {
  const [first] = read.faults;
  if (first) return isPlain(first.fault) ? undefined : words.fault(first.fault);
  if (read.tooMany) return words.onlyOne(read.registers.length);
  return read.text === undefined ? undefined : words.typeAgain(saidOf(read));
}
