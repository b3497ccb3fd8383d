import type { CrcSteps, ShiftStep } from '../../modbus/index.ts';
import { formatBinary } from '../../notation/index.ts';
import { byteHex, registerHex } from './register-text.ts';
import { SHIFTS, type StepPlace, type StepRows } from './step-rows.ts';

/** What the steps of a CRC are told with; registers and bytes come in hexadecimal. */
export interface StepsTextWords {
  readonly columns: Readonly<Record<'step' | 'before' | 'out' | 'xor' | 'after', string>>;
  byte(at: number): string;
  shift(number: number): string;
  mix(byte: string, mixed: string): string;
  xor(poly: string): string;
  readonly noXor: string;
  byteSaid(at: number, byte: string, before: string, mixed: string, after: string): string;
  /** `poly` is `undefined` if a 0 leaves the register. */
  shiftSaid(number: number, at: number, moved: string, poly: string | undefined, after: string): string;
}

/** The steps as they are shown, folded or not, with tabs between the columns for a spreadsheet. */
export function stepsText(steps: CrcSteps, rows: StepRows, words: StepsTextWords): string {
  const { columns } = words;
  const { form, bytes } = steps;
  const register = (value: number) => [registerHex(form.bits, value), formatBinary(value, form.bits)];
  const lines = [[columns.step, columns.before, '', columns.out, columns.xor, columns.after, '']];
  for (let at = 0; at < bytes.length; at++) {
    const { value, before, mixed, after } = steps.byte(at);
    const mix = words.mix(byteHex(value), registerHex(form.bits, mixed));
    lines.push([`${words.byte(at)} ${byteHex(value)}`, ...register(before), '', mix, ...register(after)]);
    if (!rows.open(at)) continue;
    for (const [i, shift] of steps.shifts(at).entries()) {
      const xor = shift.out ? words.xor(registerHex(form.bits, form.poly)) : words.noXor;
      lines.push([words.shift(i + 1), ...register(shift.before), `${shift.out}`, xor, ...register(shift.after)]);
    }
  }
  return lines.map((cells) => cells.join('\t')).join('\n');
}

/** What happens in a row, as a sentence. */
export function stepText(steps: CrcSteps, { at, shift }: StepPlace, words: StepsTextWords): string {
  const { form } = steps;
  const hex = (value: number) => registerHex(form.bits, value);
  const { value, before, mixed, after } = steps.byte(at);
  if (shift === 0) return words.byteSaid(at, byteHex(value), hex(before), hex(mixed), hex(after));
  const step = steps.shifts(at)[Math.min(shift, SHIFTS) - 1] as ShiftStep;
  const moved = hex((step.after ^ (step.out ? form.poly : 0)) >>> 0);
  return words.shiftSaid(shift, at, moved, step.out ? hex(form.poly) : undefined, hex(step.after));
}
