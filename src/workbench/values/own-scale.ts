import { ratioText } from '../../devices/index.ts';
import {
  compare,
  type Fraction,
  inverseScale,
  type NumberTypeName,
  type Order,
  orders,
  type Scale,
} from '../../modbus/index.ts';
import { readFraction, type UnitScale } from '../../notation/index.ts';
import { oneOf, record, text } from '../stored.ts';

/** The types that a scale of one's own is for. They are named here because the page knows this from the start, and the kernels not. */
export const scaleTypes = 'u16 i16 f16 bcd16 bits u32 i32 f32 bcd32 u64 i64 f64'.split(
  ' ',
) as readonly NumberTypeName[];

/** A scale as typed. Limits and the unit may be blank. */
export interface ScaleTexts {
  readonly factor: string;
  readonly offset: string;
  readonly decimals: string;
  readonly unit: string;
  readonly least: string;
  readonly most: string;
  readonly type: NumberTypeName;
  readonly order: Order;
  /** In scales that were stored without one, raw was value × factor + offset. */
  readonly version: 2;
}

export const firstScale: ScaleTexts = {
  version: 2,
  factor: '1',
  offset: '0',
  decimals: '1',
  unit: '',
  least: '',
  most: '',
  type: 'u16',
  order: 'ABCD',
};

const DECIMALS = /^(\d|1[0-2])$/;

const fraction = text((typed) => readFraction(typed) !== undefined);
const limit = text((typed) => typed.trim() === '' || readFraction(typed) !== undefined);
const decode = record<ScaleTexts>(
  {
    factor: fraction,
    offset: fraction,
    decimals: text((typed) => DECIMALS.test(typed.trim())),
    unit: text(),
    least: limit,
    most: limit,
    type: oneOf(scaleTypes),
    order: oneOf(Object.keys(orders) as Order[]),
    version: oneOf([2]),
  },
  firstScale,
);

/** The scale kept last; a part that is missing or cannot be read is as in `firstScale`, all are if they do not fit. */
export function storedScale(stored: unknown): ScaleTexts {
  const texts = decode(stored);
  if (!readScale(texts).known) return firstScale;
  return Object(stored).version === firstScale.version ? texts : fromOldMeaning(texts);
}

/** A scale of the old meaning, with the same values for the same raw numbers. */
function fromOldMeaning(texts: ScaleTexts): ScaleTexts {
  const [factor, offset] = [readFraction(texts.factor), readFraction(texts.offset)];
  if (factor === undefined || offset === undefined) return firstScale;
  const scale = inverseScale({ factor, offset });
  return { ...texts, factor: ratioText(scale.factor), offset: ratioText(scale.offset) };
}

/**
 * A scale by its full scale: `full` units are the number `raw` in a register of 16 bits, as `60` Hz are `8192`. `undefined` unless
 * both are numbers above 0 and `raw` fits.
 */
export function scaleOfFull(full: string, raw: string, unit: string): ScaleTexts | undefined {
  const [units, number] = [readFraction(full), readFraction(raw)];
  const fits = units && number && units.numerator > 0n && number.numerator > 0n && compare(number, MOST) <= 0;
  return fits ? { ...firstScale, factor: `${full.trim()}/${raw.trim()}`, unit } : undefined;
}

/** The largest number that a register holds. */
const MOST: Fraction = { numerator: 0xffffn, denominator: 1n };

/** Why the texts are not a scale: a text that is not a number, or limits that are the wrong way round. */
export type ScaleFault = 'factor' | 'offset' | 'decimals' | 'least' | 'most' | 'limits';

/** The scale that texts make, and what of them is wrong. */
export interface ScaleReading {
  readonly known: UnitScale | undefined;
  readonly faults: ReadonlySet<ScaleFault>;
}

export function readScale({ factor, offset, decimals, unit, least, most, type, order }: ScaleTexts): ScaleReading {
  const faults = new Set<ScaleFault>();
  const read = (name: ScaleFault, text: string): Fraction | undefined => {
    const value = readFraction(text);
    if (value === undefined || (name === 'factor' && value.numerator === 0n)) faults.add(name);
    return value;
  };
  const limit = (name: 'least' | 'most', text: string) => (text.trim() === '' ? undefined : read(name, text));
  const [times, plus] = [read('factor', factor), read('offset', offset)];
  const ends = { least: limit('least', least), most: limit('most', most) };
  if (ends.least && ends.most && compare(ends.least, ends.most) > 0) faults.add('limits');
  if (!DECIMALS.test(decimals.trim())) faults.add('decimals');
  if (faults.size > 0 || !times || !plus) return { known: undefined, faults };
  const scale: Scale = { factor: times, offset: plus, decimals: Number(decimals), ...ends };
  return { known: { unit: unit.trim(), scale, type, order }, faults };
}

/** The scale that texts make, if it has a unit that can be typed. */
export function scaleWithUnit(texts: ScaleTexts): UnitScale | undefined {
  const { known } = readScale(texts);
  return known && known.unit !== '' ? known : undefined;
}
