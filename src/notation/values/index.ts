export { type ValuesNotice, withPoints } from './commas.ts';
export { formatValue, formatValueHex } from './format-value.ts';
export { type Expected, findExpected, type Likely, readExpected, type ValueView, valuesAt } from './likely.ts';
export { readExact, readFraction, type TypedNumber } from './number-value.ts';
export { type PlacedFault, type PlacedValue, readValues, type ValuesReading } from './read-values.ts';
export { readOrderName, readTypeName, type TypeReading } from './type-name.ts';
export type { TypedValue, ValueFault, ValueNote } from './typed-value.ts';
export { unitOf } from './unit-of.ts';
export {
  type InUnits,
  scaleOfUnit,
  type UnitLimits,
  type UnitScale,
  type UnitsAt,
  type UnitWriting,
  writeInUnits,
} from './units.ts';
export { orderNames, typeNames } from './value-names.ts';
