export type { FormTypeName, TextTypeName } from './form-types.ts';
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
export type { Value } from './number-type.ts';
export { fromRegisters, type Order, orderName, orders, ordersOf, registerPlaces, toRegisters } from './order.ts';
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
export type { Padding, TextRoom } from './text.ts';
export {
  type FloatTypeName,
  formTypeNames,
  isBig,
  isFormType,
  isNumberType,
  isPartial,
  isTextType,
  type NumberTypeName,
  numberTypeNames,
  numberTypes,
  plainTypeNames,
  registersOf,
  shownDigits,
  textTypeNames,
  type ValueType,
  valueTypeNames,
} from './types.ts';
export { readValue, shortestFloat, type ValueReading, type ValueWriting, writeValue } from './values.ts';
