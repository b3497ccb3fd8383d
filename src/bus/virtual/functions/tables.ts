import type { EntityTable } from '../../../devices/index.ts';
import { type Masks, maskedValue } from '../../../modbus/index.ts';
import { ECHO, type Handler, noSuchAddress, reply } from './handler.ts';

/** What the fields of a request hold, once they have been checked. */
interface Asked {
  readonly startAddress: number;
  readonly address: number;
  readonly referenceAddress: number;
  readonly quantity: number;
  readonly readStartAddress: number;
  readonly readQuantity: number;
  readonly writeStartAddress: number;
}

/** 01 to 04. */
export const reads = (table: EntityTable, list: 'bits' | 'registers'): Handler => ({
  perform({ tables }, { fields }) {
    const { startAddress, quantity } = fields as unknown as Asked;
    const cells = tables[table];
    return cells.has(startAddress, quantity) ? reply({ [list]: cells.read(startAddress, quantity) }) : noSuchAddress;
  },
});

/** 05 */
export const writeCoil: Handler = {
  perform({ tables, traits }, { fields, forced }) {
    const { address } = fields as unknown as Asked;
    if (!tables.coil.has(address, 1, true)) return noSuchAddress;
    const raw = forced['rawValue'];
    const on =
      typeof raw === 'number' && traits.includes('any-value-is-on') ? raw >> 8 !== 0 : fields['value'] === true;
    tables.coil.write(address, [on ? 1 : 0]);
    return ECHO;
  },
};

/** 06 */
export const writeRegister: Handler = {
  perform({ tables }, { fields }) {
    const { address } = fields as unknown as Asked;
    const cells = tables['holding-register'];
    if (!cells.has(address, 1, true)) return noSuchAddress;
    cells.write(address, [fields['value'] as number]);
    return ECHO;
  },
};

/** 0F and 10 */
export const writes = (table: EntityTable, list: 'bits' | 'registers'): Handler => ({
  perform({ tables }, { fields, derived }) {
    const { startAddress } = fields as unknown as Asked;
    const quantity = derived['quantity'] as number;
    const cells = tables[table];
    if (!cells.has(startAddress, quantity, true)) return noSuchAddress;
    // A byte count that a device takes although it is one too many brings bits beyond the quantity.
    cells.write(startAddress, (fields[list] as readonly number[]).slice(0, quantity));
    return reply({ startAddress, quantity });
  },
});

/** 16 */
export const maskRegister: Handler = {
  perform({ tables }, { fields }) {
    const { referenceAddress } = fields as unknown as Asked;
    const cells = tables['holding-register'];
    if (!cells.has(referenceAddress, 1, true)) return noSuchAddress;
    const [current = 0] = cells.read(referenceAddress, 1);
    cells.write(referenceAddress, [maskedValue(current, fields as unknown as Masks)]);
    return ECHO;
  },
};

/** 17: the write is done before the read (AP 6.17). */
export const readWriteRegisters: Handler = {
  perform({ tables }, { fields }) {
    const { readStartAddress, readQuantity, writeStartAddress } = fields as unknown as Asked;
    const written = fields['writeRegisters'] as readonly number[];
    const cells = tables['holding-register'];
    if (!cells.has(readStartAddress, readQuantity) || !cells.has(writeStartAddress, written.length, true)) {
      return noSuchAddress;
    }
    cells.write(writeStartAddress, written);
    return reply({ registers: cells.read(readStartAddress, readQuantity) });
  },
};
