import type { CrcSteps } from '../../modbus/index.ts';
import { formatBinary } from '../../notation/index.ts';
import { stepWords as words } from './language.ts';
import { byteHex, registerHex } from './registers.tsx';
import type { Rows } from './rows.ts';

/** The steps as they are shown, folded or not, with tabs between the columns for a spreadsheet. */
export function stepsText(steps: CrcSteps, rows: Rows): string {
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
