import {
  numberTypeNames,
  numberTypes,
  type Order,
  orders,
  readValue,
  type Value,
  type ValueType,
} from '../modbus/index.ts';

/** What a register of a profile may hold. `bits` is 16 named bits of a register, or the elements of a table of bits. */
export const valueTypes: readonly ValueType[] = [...numberTypeNames, 'text'];
export const byteOrders = Object.keys(orders) as readonly Order[];

/** Registers of 16 bits that one value takes; of text, each register is counted by itself. */
export const wordsOf = (type: ValueType): number => (type === 'text' ? 1 : numberTypes[type].registers);

/**
 * The value that registers hold; `undefined` if they hold no value of this type. Blanks at the end of a text are padding too.
 */
export function heldValue(words: readonly number[], type: ValueType, order: Order): Value | undefined {
  const reading = readValue(words, type, order);
  if (reading.kind !== 'value') return undefined;
  return typeof reading.value === 'string' ? reading.value.trimEnd() : reading.value;
}
