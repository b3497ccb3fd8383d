import { isBitTable } from '../devices/index.ts';
import { encodeFrame, numberTypes, readerOf, readValue, type SerialMode, type Value } from '../modbus/index.ts';
import type { Relation, Until } from './sequence.ts';

type Asked = Pick<Until, 'unit' | 'table' | 'address' | 'type'>;

/** How many elements of the table the value of a condition takes. */
export const elementsOf = ({ table, type }: Pick<Until, 'table' | 'type'>): number =>
  isBitTable(table) ? 1 : numberTypes[type].registers;

/** The request that reads what a condition is about (AP 6.1 to 6.4). */
export const readingRequest = (until: Asked, transport: SerialMode): Uint8Array =>
  encodeFrame({
    transport,
    direction: 'request',
    unitId: until.unit,
    functionCode: readerOf(until.table).code,
    fields: { startAddress: until.address, quantity: elementsOf(until) },
  });

/** The value in the fields of a reply; `undefined` if the reply has no value of this type. */
export function valueIn(fields: Readonly<Record<string, unknown>>, until: Until): Value | undefined {
  if (isBitTable(until.table)) return numbers(fields['bits'])[0];
  const reading = readValue(numbers(fields['registers']), until.type, until.order);
  if (reading.kind !== 'value') return undefined;
  if (until.bit === undefined) return reading.value;
  return Number((BigInt(reading.value) >> BigInt(until.bit)) & 1n);
}

const numbers = (list: unknown): readonly number[] => (Array.isArray(list) ? list.map(Number) : []);

const HOLDS: { readonly [R in Relation]: (got: number | bigint, value: number) => boolean } = {
  // A bigint and a number are compared by their values, without rounding either; nothing is equal to NaN.
  '=': (got, value) => got >= value && got <= value,
  '≠': (got, value) => got < value || got > value,
  '<': (got, value) => got < value,
  '≤': (got, value) => got <= value,
  '>': (got, value) => got > value,
  '≥': (got, value) => got >= value,
};

/** Whether a condition holds for what was read. */
export const holds = ({ relation, value }: Pick<Until, 'relation' | 'value'>, got: Value): boolean =>
  typeof got !== 'string' && HOLDS[relation](got, value);
