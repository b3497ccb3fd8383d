import {
  compare,
  type Fraction,
  fraction,
  isBig,
  isOutside,
  type NumberTypeName,
  numberTypes,
  type Order,
  rawExactly,
  type Scale,
  shortestFloat,
  toNumber,
  toRaw,
  unitsExactly,
  writeValue,
} from '../../modbus/index.ts';
import { readExact } from './number-value.ts';

/** How values in a unit stand in registers. */
export interface UnitScale {
  readonly unit: string;
  readonly scale: Scale;
  readonly type: NumberTypeName;
  readonly order: Order;
}

/** The units known of the value that begins this many registers after the first. */
export type UnitsAt = (place: number) => readonly UnitScale[];

/** The number in the registers for a value in units, and what that number stands for. */
export interface InUnits {
  readonly unit: string;
  readonly raw: number | bigint;
  readonly type: NumberTypeName;
  /** Whether it stands for the very value. */
  readonly exact: boolean;
  readonly stands: Fraction;
  /** Digits behind the point that values of this unit are shown with. */
  readonly decimals: number;
}

/** Limits in a unit; `undefined` if there is no limit. */
export interface UnitLimits {
  readonly unit: string;
  readonly least: Fraction | undefined;
  readonly most: Fraction | undefined;
  readonly decimals: number;
}

export type UnitWriting =
  | { readonly kind: 'registers'; readonly registers: readonly number[]; readonly inUnits: InUnits }
  | { readonly kind: 'outside-limits'; readonly limits: UnitLimits }
  /** The raw number does not fit into the type, which holds values within `limits`. */
  | {
      readonly kind: 'outside-type';
      readonly raw: Fraction;
      readonly type: NumberTypeName;
      readonly limits: UnitLimits;
    };

/** Letters that look the same are the same: `m³` and `m3`, the micro sign and the Greek letter. */
const plainUnit = (unit: string) => unit.normalize('NFKC').replace(/\s+/g, '').toLowerCase();

/** The scale for a unit as typed. Capitals count only where two units differ in nothing else (`mA`, `MA`). */
export function scaleOfUnit(typed: string, known: readonly UnitScale[]): UnitScale | undefined {
  const exactly = known.find(({ unit }) => unit === typed);
  if (exactly) return exactly;
  const alike = known.filter(({ unit }) => plainUnit(unit) === plainUnit(typed));
  return new Set(alike.map(({ unit }) => unit)).size === 1 ? alike[0] : undefined;
}

/** The registers that hold a value in units: the nearest number that the type holds, halves away from 0. */
export function writeInUnits(value: Fraction, { unit, scale, type, order }: UnitScale): UnitWriting {
  const { least, most, decimals } = scale;
  if (isOutside(value, scale)) return { kind: 'outside-limits', limits: { unit, least, most, decimals } };
  const raw = rawFor(value, scale, type);
  const written = writeValue(raw, type, order);
  if (written.kind !== 'registers') {
    return { kind: 'outside-type', raw: rawExactly(value, scale), type, limits: limitsOf(type, unit, scale) };
  }
  const stored = written.stored as number | bigint;
  const stands = unitsExactly(exactlyStored(stored, type), scale);
  const exact = compare(stands, value) === 0;
  return {
    kind: 'registers',
    registers: written.registers,
    inUnits: { unit, raw: stored, type, exact, stands, decimals },
  };
}

function rawFor(value: Fraction, scale: Scale, type: NumberTypeName): number | bigint {
  if (numberTypes[type].kind === 'float') return toNumber(rawExactly(value, scale));
  const reading = toRaw(value, scale);
  const raw = reading.kind === 'raw' ? reading.raw : 0n;
  return isBig(type) ? raw : Number(raw);
}

/** A number in registers exactly; of a float, its shortest decimal. */
const exactlyStored = (stored: number | bigint, type: NumberTypeName): Fraction =>
  numberTypes[type].kind === 'float'
    ? (readExact(shortestFloat(Number(stored), type))?.exactly ?? fraction(0))
    : fraction(stored);

/** What a type can hold, in units. */
function limitsOf(type: NumberTypeName, unit: string, scale: Scale): UnitLimits {
  const { least, most } = numberTypes[type];
  const ends = [least, most].map((end) => unitsExactly(fraction(end), scale)).toSorted(compare);
  return { unit, least: ends[0], most: ends[1], decimals: scale.decimals };
}
