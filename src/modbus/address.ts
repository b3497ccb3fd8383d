import type { Layout } from './field.ts';
import type { FunctionCode, Table } from './function-code.ts';
import { describeFunction, functionCodes } from './functions/index.ts';

/** The first digit of the numbers that manuals give a table's elements (PI ch. 2; extended memory, fn 20). */
export const tableDigits: Readonly<Record<Table, string>> = {
  coil: '0',
  'discrete-input': '1',
  'input-register': '3',
  'holding-register': '4',
  'file-record': '6',
};

/** The functions that address a table, in ascending order of their codes. */
export const functionsOf = (table: Table): readonly FunctionCode[] =>
  functionCodes.filter((description: FunctionCode) => description.table === table);

/** What a request asks for, so that two functions can be told to ask for the same. */
const shapeOf = ({ fields }: Layout): string => fields.map(({ name, kind }) => `${name} ${kind}`).join();

/**
 * The function whose request has the same fields as that of `code` but is of another table: 04 for 03 and input
 * registers. `undefined` where there is none, such as for writing to input registers.
 */
export function counterpart(code: number, table: Table): FunctionCode | undefined {
  const shape = shapeOf(describeFunction(code, 'request').request);
  return functionsOf(table).find(({ request }) => shapeOf(request) === shape);
}

/** The name of the quantity that goes with an address, if one does: `readQuantity` with `readStartAddress`. */
export function quantityOf(addressName: string): string | undefined {
  const name = addressName.replace(/[sS]tartAddress$/, (found) => (found.startsWith('S') ? 'Quantity' : 'quantity'));
  return name === addressName ? undefined : name;
}
