import {
  type Order,
  orders,
  readValue,
  registersOf,
  type Value,
  type ValueType,
  valueTypeNames,
} from '../modbus/index.ts';

/** What a register of a profile may hold. `bits` is 16 named bits of a register, or the elements of a table of bits. */
export const valueTypes: readonly ValueType[] = valueTypeNames;
export const byteOrders = Object.keys(orders) as readonly Order[];

/** Registers of 16 bits that one value takes; of text, each register is counted by itself. */
export const wordsOf = (type: ValueType): number => registersOf(type);

/**
 * The value that registers hold; `undefined` if they hold no value of this type. Blanks at the end of a text are padding too.
 */
export function heldValue(words: readonly number[], type: ValueType, order: Order): Value | undefined {
  const reading = readValue(words, type, order);
  if (reading.kind !== 'value') return undefined;
  return typeof reading.value === 'string' ? reading.value.trimEnd() : reading.value;
}
