import { type ValuesNotice, withPoints } from '../../../notation/index.ts';
import type { ValueWords } from '../../../words/index.ts';
import {
  type Control,
  readTyped,
  registersText,
  shownAt,
  type TypedFault,
  type TypedReading,
  typedFault,
  valueInFrame,
  withTyped,
} from '../../../workbench/index.ts';
import { device, devicesCame } from '../../parts/device/naming.ts';
import { draft, edit, evaluation } from '../../parts/store.ts';
import { valueStore } from '../../parts/value-store.ts';

/** Registers shown before they are put into the frame. */
const SHOWN = 16;

/** The registers of typed values. */
export const registersLine = (registers: readonly number[], words: ValueWords): string =>
  `${words.registers(registers.length)} ${registersText(registers.slice(0, SHOWN))}${registers.length > SHOWN ? ' …' : ''}`;

/** What values come to: their notes, and their registers where the notes do not say them. */
function outcomeOf({ values, registers }: TypedReading, words: ValueWords): string {
  const notes = values.slice(0, SHOWN).flatMap((value) => value.notes.map(words.note));
  return values.length === 1 && values[0]?.notes[0]?.code === 'in-units'
    ? notes.join(' ')
    : [...notes, registersLine(registers, words)].join(' ');
}

/** Takes what is typed into a field of registers: values as they are, `30 Hz`, `f32 CDAB 21.5`. */
export function typeValues(control: Control, typed: string): void {
  const inFrame = valueInFrame(typed, fieldOf(control), valueStore.units.value);
  edit(withTyped(draft.value, control.path, typed, inFrame, device.value?.id));
}

const fieldOf = (control: Control) => ({ control, draft: draft.value, evaluation: evaluation.value });

interface FieldValues {
  readonly text: string;
  /** A unit that was typed, of which nothing here says what it is in registers. */
  readonly unit: string | undefined;
  readonly hint: string | undefined;
  readonly wrong: string | undefined;
  /** A number of it that may be read in another way. */
  readonly other: ValuesNotice | undefined;
}

/** What a field of registers shows, with what its values come to, or why they are not values. */
export function typedValues(control: Control, words: ValueWords): FieldValues {
  const { path, text } = control;
  const field = fieldOf(control);
  const units = valueStore.units.value;
  const { text: shown, notHere } = shownAt(field.draft, path, text, (typed) => valueInFrame(typed, field, units));
  const fault = typedFault(text, field, units);
  return {
    text: shown,
    unit: fault?.code === 'unit' ? fault.unit : undefined,
    hint:
      shown !== text
        ? outcomeOf(readTyped(shown, field, units), words)
        : notHere !== undefined && devicesCame.value
          ? words.notHere(notHere)
          : undefined,
    wrong: faultText(fault, words),
    // In a text that the frame itself has, commas make a list.
    other: withPoints(shown).notices.find(({ code }) => code !== 'decimal-comma' || shown !== text),
  };
}

function faultText(fault: TypedFault | undefined, words: ValueWords): string | undefined {
  switch (fault?.code) {
    case 'fault':
      return words.fault(fault.fault);
    case 'too-many':
      return words.onlyOne(fault.registers);
    case 'unit':
      return words.unitOpen(fault.typed);
    case 'type-again':
      return words.typeAgain(outcomeOf(fault.read, words));
    default:
      return undefined;
  }
}
