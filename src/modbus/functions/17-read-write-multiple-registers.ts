import { layout } from '../field.ts';
import { address, bytesOfRegisters, count, fitsQuantity, lengthOf, quantity } from '../fields/number.ts';
import { registers } from '../fields/registers.ts';
import { defineFunction } from '../function-code.ts';
import { MOST_REGISTERS_READ, readRegistersResponse } from './read-registers.ts';

const MOST_WRITTEN = 121;

/** The write is done before the read. */
export const readWriteMultipleRegisters = defineFunction({
  code: 0x17,
  name: 'Read/Write Multiple Registers',
  section: 'AP 6.17',
  group: 'registers',
  table: 'holding-register',
  items: 'many',
  access: 'reads-and-writes',
  request: layout([
    address('readStartAddress'),
    quantity('readQuantity', { from: 'readStartAddress', least: 1, most: MOST_REGISTERS_READ }),
    address('writeStartAddress'),
    quantity('writeQuantity', {
      from: 'writeStartAddress',
      least: 1,
      most: MOST_WRITTEN,
      derive: lengthOf('writeRegisters'),
    }),
    count('writeByteCount', {
      least: 2,
      most: bytesOfRegisters(MOST_WRITTEN),
      derive: lengthOf('writeRegisters', bytesOfRegisters),
      rules: [fitsQuantity(bytesOfRegisters)],
    }),
    registers('writeRegisters', ({ count }) => count),
  ]),
  response: readRegistersResponse('readQuantity'),
});
