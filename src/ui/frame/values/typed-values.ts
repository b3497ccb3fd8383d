import {
  type Control,
  type Draft,
  readTyped,
  registersText,
  roomOf,
  shownAt,
  type TypedFault,
  type TypedReading,
  typedFault,
  type UnitSource,
  valueInFrame,
  withTyped,
} from '../../../workbench/index.ts';
import { device, devicesCame } from '../../parts/device/naming.ts';
import { edit, evaluation } from '../../parts/store.ts';
import { ownScale } from './scale.ts';
import type { ValueAid } from './value-aid.ts';
import { valueWords as words } from './value-words.ts';

/** Registers shown before they are put into the frame. */
const SHOWN = 16;

/** Where the units of values come from now. */
export const unitSource = (): UnitSource => ({ device: device.value, own: ownScale() });

/** The registers of typed values. */
export const registersSaid = (registers: readonly number[]): string =>
  `${words.registers(registers.length)} ${registersText(registers.slice(0, SHOWN))}${registers.length > SHOWN ? ' …' : ''}`;

/** What values come to: their notes, and their registers where the notes do not say them. */
function saidOf({ values, registers }: TypedReading): string {
  const notes = values.slice(0, SHOWN).flatMap((value) => value.notes.map(words.note));
  return values.length === 1 && values[0]?.notes[0]?.code === 'in-units'
    ? notes.join(' ')
    : [...notes, registersSaid(registers)].join(' ');
}

/** Lets values be typed into a field of registers as they are: `30 Hz`, `f32 CDAB 21.5`. */
export function typedValues(control: Control, draft: Draft): ValueAid | undefined {
  const { path, text } = control;
  const field = { control, draft, evaluation: evaluation.value };
  if (roomOf(control, field.evaluation) === 0) return undefined;
  const units = unitSource();
  const inFrame = (typed: string) => valueInFrame(typed, field, units);
  const { text: shown, notHere } = shownAt(draft, path, text, inFrame);
  return {
    typed: {
      text: shown,
      onText: (typed) => edit(withTyped(draft, path, typed, inFrame(typed), device.value?.id)),
    },
    said:
      shown !== text
        ? saidOf(readTyped(shown, field, units))
        : notHere !== undefined && devicesCame.value
          ? words.notHere(notHere)
          : undefined,
    wrong: faultText(typedFault(text, field, units)),
  };
}

function faultText(fault: TypedFault | undefined): string | undefined {
  switch (fault?.code) {
    case 'fault':
      return words.fault(fault.fault);
    case 'too-many':
      return words.onlyOne(fault.registers);
    case 'type-again':
      return words.typeAgain(saidOf(fault.read));
    default:
      return undefined;
  }
}
