import {
  compare,
  type Fraction,
  type NumberTypeName,
  numberTypeNames,
  type Order,
  orders,
  type Scale,
} from '../../modbus/index.ts';
import { readFraction, type UnitScale } from '../../notation/index.ts';
import { Cell } from '../cell.ts';
import { Remembered } from '../tools/remembered.ts';

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
}

const initial: ScaleTexts = {
  factor: '1',
  offset: '0',
  decimals: '1',
  unit: '',
  least: '',
  most: '',
  type: 'u16',
  order: 'ABCD',
};

/** What is stored may be older, with fewer texts. */
const remembered = new Remembered<ScaleTexts>('scale', initial, (value) => {
  const texts = { ...initial, ...(value as Partial<ScaleTexts> | null) };
  const known = numberTypeNames.includes(texts.type) && Object.hasOwn(orders, texts.order);
  return known && Object.values(texts).every((text) => typeof text === 'string') ? texts : undefined;
});

/** The scale typed last, which other fields follow. */
export const scaleTexts = new Cell<ScaleTexts>(remembered.value);

export function setScale(change: Partial<ScaleTexts>): void {
  remembered.value = { ...scaleTexts.value, ...change };
  scaleTexts.value = remembered.value;
}

/** A text of a scale that is none. */
export type ScaleFault = 'factor' | 'offset' | 'decimals' | 'least' | 'most' | 'limits';

/** The scale that texts say, and what of them is wrong. */
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
  if (!/^(\d|1[0-2])$/.test(decimals.trim())) faults.add('decimals');
  if (faults.size > 0 || !times || !plus) return { known: undefined, faults };
  const scale: Scale = { factor: times, offset: plus, decimals: Number(decimals), ...ends };
  return { known: { unit: unit.trim(), scale, type, order }, faults };
}

/** One's own scale, where it has a unit that can be typed. */
export function ownScale(): UnitScale | undefined {
  const { known } = readScale(scaleTexts.value);
  return known && known.unit !== '' ? known : undefined;
}
