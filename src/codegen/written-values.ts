import { namedValues, type Profile, unitScale } from '../devices/index.ts';
import { fieldsOf, firstAddress, numberTypes, type Reading } from '../modbus/index.ts';
import type { UnitScale } from '../notation/index.ts';
import { plainWords } from '../notation/index.ts';
import type { Name } from './code.ts';
import { isWritable } from './routines/scaled.ts';

/** A value in units that a request writes. */
export interface WrittenValue {
  readonly name: string;
  /** The field of the request, and the place in its list; 0 for a number. */
  readonly field: string;
  readonly index: number;
  /** `undefined` if a program cannot make its registers of a value in units. */
  readonly scale: UnitScale | undefined;
  /** The number in its register. */
  readonly raw: number;
}

/** The scaled values of a device that a request writes: into registers of a list, or into one. */
export function writtenValues(reading: Reading, profile: Profile): readonly WrittenValue[] {
  const { description, fields } = reading;
  const table = description?.table;
  if (table !== 'holding-register' || description?.access === 'reads') return [];
  const placed = [...fieldsOf(description, 'request', fields)].map(({ field }) => field);
  return placed.flatMap(({ name: field, kind }) => {
    const value = fields[field];
    const one = description?.items === 'one' && kind === 'number' && typeof value === 'number' ? [value] : undefined;
    const words = kind === 'registers' ? (value as readonly number[]) : one;
    const at = placed.find((other) => other.kind === 'address')?.name ?? '';
    const address = one === undefined ? firstAddress(reading, field) : fields[at];
    if (words === undefined || typeof address !== 'number') return [];
    return namedValues(profile, table, address, words).flatMap(({ register, name, at, raw }) => {
      const scale = unitScale(register);
      if (scale === undefined) return [];
      const fits = isWritable(scale) && typeof raw === 'number';
      return [{ name, field, index: at, scale: fits ? scale : undefined, raw: Number(raw ?? 0) }];
    });
  });
}

/** Two values of one scale are made by one routine. */
export const scaleKey = ({ scale, type, unit }: UnitScale): string => {
  const { least, most } = numberTypes[type];
  const fractions = [scale.factor, scale.offset].map(({ numerator, denominator }) => `${numerator}/${denominator}`);
  return [unit, least, most, ...fractions].join(' ');
};

const SIGNS: ReadonlyMap<string, string> = new Map([
  ['%', 'percent'],
  ['‰', 'per mille'],
  ['°', 'degrees'],
  ['Ω', 'ohm'],
]);

/** What a unit is called in a name: `hz`, `percent`, `m3 h`. */
export function unitWords(unit: string): Name {
  const spelled = [...unit.normalize('NFKC')].map((one) => (SIGNS.has(one) ? ` ${SIGNS.get(one)} ` : one)).join('');
  const words = plainWords(spelled);
  return words === '' ? 'units' : words;
}
