import { isBitTable, isOwnOn, takesAnyOn } from '../../../devices/index.ts';
import { functionOf, maskedValue } from '../../../modbus/index.ts';
import { ECHO, type Handler, handle, noSuchAddress, reply } from './handler.ts';

/** 01 to 04. */
export function reads(code: 1 | 2 | 3 | 4): Handler {
  const { table } = functionOf(code);
  const list = isBitTable(table) ? 'bits' : 'registers';
  return handle(code, ({ tables }, { startAddress, quantity }) => {
    const cells = tables[table];
    return cells.has(startAddress, quantity) ? reply({ [list]: cells.read(startAddress, quantity) }) : noSuchAddress;
  });
}

export const writeCoil = handle(0x05, (device, { address, value }, { forced }) => {
  const { tables } = device;
  if (!tables.coil.has(address, 1, true)) return noSuchAddress;
  const raw = forced['rawValue'];
  const on = typeof raw === 'number' && takesAnyOn(device) ? isOwnOn(device, raw) : value;
  tables.coil.write(address, [on ? 1 : 0]);
  return ECHO;
});

export const writeRegister = handle(0x06, ({ tables }, { address, value }) => {
  const cells = tables['holding-register'];
  if (!cells.has(address, 1, true)) return noSuchAddress;
  cells.write(address, [value]);
  return ECHO;
});

export const writeCoils = handle(0x0f, ({ tables: { coil } }, { startAddress, quantity, bits }) => {
  if (!coil.has(startAddress, quantity, true)) return noSuchAddress;
  // A byte count that a device takes although it is one too many brings bits beyond the quantity.
  coil.write(startAddress, bits.slice(0, quantity));
  return reply({ startAddress, quantity });
});

export const writeRegisters = handle(0x10, ({ tables }, { startAddress, quantity, registers }) => {
  const cells = tables['holding-register'];
  if (!cells.has(startAddress, quantity, true)) return noSuchAddress;
  cells.write(startAddress, registers);
  return reply({ startAddress, quantity });
});

export const maskRegister = handle(0x16, ({ tables }, { referenceAddress, andMask, orMask }) => {
  const cells = tables['holding-register'];
  if (!cells.has(referenceAddress, 1, true)) return noSuchAddress;
  const [current = 0] = cells.read(referenceAddress, 1);
  cells.write(referenceAddress, [maskedValue(current, { andMask, orMask })]);
  return ECHO;
});

/** The write is done before the read (AP 6.17). */
export const readWriteRegisters = handle(0x17, ({ tables }, asked) => {
  const { readStartAddress, readQuantity, writeStartAddress, writeRegisters } = asked;
  const cells = tables['holding-register'];
  if (!cells.has(readStartAddress, readQuantity) || !cells.has(writeStartAddress, writeRegisters.length, true)) {
    return noSuchAddress;
  }
  cells.write(writeStartAddress, writeRegisters);
  return reply({ registers: cells.read(readStartAddress, readQuantity) });
});
