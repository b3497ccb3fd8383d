/** The four tables of the data model (AP 4.3), and the file records of extended memory (AP 6.14). */
export type Table = 'coil' | 'discrete-input' | 'input-register' | 'holding-register' | 'file-record';

/** Each table has 65536 addresses, counted from 0 (AP 4.4). */
export const LAST_ADDRESS = 0xffff;

/** The first digit of the numbers that manuals give a table's elements (PI ch. 2; extended memory, fn 20). */
export const tableDigits: Readonly<Record<Table, string>> = {
  coil: '0',
  'discrete-input': '1',
  'input-register': '3',
  'holding-register': '4',
  'file-record': '6',
};

/** The name of the quantity that goes with an address, if one does: `readQuantity` with `readStartAddress`. */
export function quantityOf(addressName: string): string | undefined {
  const name = addressName.replace(/[sS]tartAddress$/, (found) => (found.startsWith('S') ? 'Quantity' : 'quantity'));
  return name === addressName ? undefined : name;
}
