export { formatValue, formatValueHex } from './format-value.ts';
export { type Expected, findExpected, type Likely, readExpected, type ValueView, valuesAt } from './likely.ts';
export { readExact, readFraction, type TypedNumber } from './number-value.ts';
export {
  readValues,
  type TypedValue,
  type ValueFault,
  type ValueNote,
  type ValuePlace,
  type ValuesReading,
} from './read-values.ts';
export { orderNames, typeNames } from './value-names.ts';
