export {
  add,
  compare,
  decimalOf,
  divide,
  exactFraction,
  type Fraction,
  formatFraction,
  fraction,
  multiply,
  roundTo,
  simplestFraction,
  subtract,
  toNumber,
} from './fraction.ts';
export { type BitEffect, bitEffects, type Masks, maskedValue, masksFor } from './mask.ts';
export { fromRegisters, type Order, orderName, orders, ordersOf, toRegisters } from './order.ts';
export {
  fromRaw,
  inverseScale,
  isOutside,
  type RawReading,
  rawExactly,
  type Scale,
  type ScaledReading,
  toRaw,
  unitsExactly,
} from './scale.ts';
export type { Padding } from './text.ts';
export {
  type FloatTypeName,
  isNumberType,
  type NumberTypeName,
  numberTypeNames,
  numberTypes,
  shownDigits,
  type Value,
  type ValueType,
} from './types.ts';
export { readValue, shortestFloat, type TextRoom, type ValueReading, type ValueWriting, writeValue } from './values.ts';
