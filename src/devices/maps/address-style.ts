import { plcMeanings } from '../../notation/index.ts';
import type { AddressStyle } from './address-cell.ts';

/** How a column of addresses is written, and what of it is not sure. */
export interface StyleReading {
  readonly style: AddressStyle;
  /** Digits that may be decimal or hexadecimal: `0064`. */
  readonly doubtful?: 'base';
  readonly grouped?: true;
}

/** The digit of a table with a letter or a hyphen behind it; that of coils looks like a hexadecimal number. */
const PREFIXED = /^([0134])[xX:-]\s?(\d{1,5})$/;
const BARE = /^[\da-f]{1,6}$/i;

/** Finds how a column of addresses is written, from all its cells; `header` may say `hex` or `dec`. */
export function styleOf(cells: readonly string[], header: string, answer?: string): StyleReading {
  const filled = cells.map((cell) => cell.trim()).filter((cell) => cell !== '');
  const bare = filled.filter((cell) => BARE.test(cell));
  const saysHex = /hex|十六进制|0x/i.test(header);
  const saysDecimal = /\bdec|dezimal|décimal|十进制/i.test(header);
  if (areDevices(filled)) return { style: { plc: true } };
  const grouped = isGrouped(filled);
  const prefixed = prefixOf(filled);
  const done = (hex: boolean): StyleReading => ({
    style: { ...(hex ? { hex } : {}), ...(grouped ? { grouped } : {}), ...prefixed },
    ...(grouped ? { grouped } : {}),
  });
  if (answer === 'decimal' || answer === 'hexadecimal') return done(answer === 'hexadecimal');
  if (bare.length === 0 || grouped) return done(false);
  // A letter among the digits of one is enough; E alone may be an exponent that a spreadsheet made.
  const letters = bare.some((cell) => /[a-df]/i.test(cell) && /\d/.test(cell));
  const mostlyBare = bare.length > filled.length * 0.8;
  if (letters && mostlyBare && bare.some((cell) => /\d/.test(cell))) return done(true);
  if (saysHex && !saysDecimal && mostlyBare) return done(true);
  const fourDigits = bare.every((cell) => cell.length === 4) && bare.some((cell) => /^0/.test(cell)) && bare.length > 1;
  if (!fourDigits || saysDecimal || countsInTens(bare)) return done(false);
  return { style: { hex: true }, doubtful: 'base' };
}

/** Whether cells are names of devices inside a controller: `D100`, `V2000`. Hexadecimal numbers have other letters and lengths, too. */
export function areDevices(cells: readonly string[]): boolean {
  const named = cells.filter((cell) => plcMeanings(cell.replace(/\.\d{1,2}$/, '')).length > 0);
  const areHex = cells.every((cell) => BARE.test(cell)) && new Set(cells.map(({ length }) => length)).size === 1;
  return named.length > cells.length / 2 && !(areHex && cells.some((cell) => /^.0|[a-f].*[a-f]/i.test(cell)));
}

/** What numbers such as `4x0001` of other tables say of `0x0003`, and whether they count from 0. */
function prefixOf(cells: readonly string[]): Pick<AddressStyle, 'modicon' | 'fromZero'> {
  const found = cells.flatMap((cell) => {
    const [, digit = '', number = ''] = PREFIXED.exec(cell) ?? [];
    return digit === '' ? [] : [{ digit, number }];
  });
  const sure = found.filter(({ digit }) => digit !== '0');
  if (sure.length === 0) return {};
  const lengths = new Set(sure.map(({ number }) => number.length));
  const modicon =
    found.every(({ number }) => lengths.has(number.length)) && !cells.some((cell) => /^0x.*[a-f]/i.test(cell));
  const counted = modicon ? found : sure;
  return { ...(modicon && { modicon }), ...(counted.some(({ number }) => Number(number) === 0) && { fromZero: true }) };
}

/** Every number with a point or comma has three digits behind it, and a number without has fewer than four. */
function isGrouped(cells: readonly string[]): true | undefined {
  const dotted = cells.filter((cell) => /[.,]/.test(cell));
  const whole = cells.filter((cell) => /^\d+$/.test(cell));
  return dotted.length > 0 &&
    dotted.every((cell) => /^\d{1,3}(?:[.,]\d{3})+$/.test(cell)) &&
    whole.every((cell) => cell.length < 4)
    ? true
    : undefined;
}

/** 0009 is followed by 0010: no hexadecimal number comes between. */
function countsInTens(cells: readonly string[]): boolean {
  return cells.some(
    (cell, place) => /9$/.test(cell) && cells[place + 1] === String(Number(cell) + 1).padStart(cell.length, '0'),
  );
}
