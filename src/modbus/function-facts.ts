import type { Table } from './address.ts';
import { fieldsOf, type Layout } from './field.ts';
import type { FunctionAccess, FunctionCode } from './function-code.ts';
import { describeFunction, functionCodes } from './functions/index.ts';
import type { Reading } from './reading.ts';

/** The functions that address a table, in ascending order of their codes. */
export const functionsOf = (table: Table): readonly FunctionCode[] =>
  functionCodes.filter((description: FunctionCode) => description.table === table);

/**
 * What a request does to a device: what the description of its function says, if need be by the value of a field. A request
 * that nobody described may change the device.
 */
export function accessOf({ description, fields }: Pick<Reading, 'description' | 'fields'>): FunctionAccess {
  const access = description?.access ?? 'writes';
  if (typeof access === 'string') return access;
  return access.reads.some((value) => value === fields[access.by]) ? 'reads' : 'writes';
}

/** Whether a function writes at the address in the request's field of this name. */
export const writesAt = ({ access }: FunctionCode, addressName: string): boolean =>
  access === 'writes' || (access === 'reads-and-writes' && addressName.startsWith('write'));

/** The function that reads many elements of a table, or that writes one or many; `undefined` if there is none. */
export const functionFor = (
  table: Table,
  access: 'reads' | 'writes',
  items: 'one' | 'many',
): FunctionCode | undefined =>
  functionsOf(table).find((description) => description.access === access && description.items === items);

/** The function that reads many elements of a table (AP 6.1 to 6.4). */
export const readerOf = (table: Exclude<Table, 'file-record'>): FunctionCode =>
  found(functionFor(table, 'reads', 'many'), table);

/** The function that writes one or many elements of a table (AP 6.5, 6.6, 6.11, 6.12). */
export const writerOf = (table: 'coil' | 'holding-register', items: 'one' | 'many'): FunctionCode =>
  found(functionFor(table, 'writes', items), table);

function found(description: FunctionCode | undefined, table: Table): FunctionCode {
  if (description === undefined) throw new RangeError(`no such function of the table ${table}`);
  return description;
}

/** Most elements that a request asks for, or writes, by its first quantity; 1 if it has no quantity. */
export function mostOf(description: FunctionCode): number {
  for (const { field } of fieldsOf(description, 'request', {})) {
    if (field.kind === 'quantity' && field.range !== undefined) return field.range.most;
  }
  return 1;
}

/** What a request asks for, so that two functions can be told to ask for the same. */
const shapeOf = ({ fields }: Layout): string => fields.map(({ name, kind }) => `${name} ${kind}`).join();

/**
 * The function whose request has the same fields as that of `code` but is of another table: 04 for 03 and input
 * registers. `undefined` if there is none, for example for writing to input registers.
 */
export function counterpart(code: number, table: Table): FunctionCode | undefined {
  const shape = shapeOf(describeFunction(code, 'request').request);
  return functionsOf(table).find(({ request }) => shapeOf(request) === shape);
}

/** The counterpart of `code` in the other table of bits, or of registers: 04 for 03, and 03 for 04. */
export function twinOf(code: number): FunctionCode | undefined {
  const { request, table, group } = describeFunction(code, 'request');
  const shape = shapeOf(request);
  return functionCodes.find(
    (other: FunctionCode) =>
      table !== undefined && other.table !== table && other.group === group && shapeOf(other.request) === shape,
  );
}
