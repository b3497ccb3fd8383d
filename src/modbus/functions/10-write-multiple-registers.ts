import { layout } from '../field.ts';
import { address, bytesOfRegisters, count, echoes, fitsQuantity, lengthOf, quantity } from '../fields/number.ts';
import { registers } from '../fields/registers.ts';
import { defineFunction } from '../function-code.ts';

const limits = { from: 'startAddress', least: 1, most: 123, oldLimit: 100 } as const;

export const writeMultipleRegisters = defineFunction({
  code: 0x10,
  name: 'Write Multiple Registers',
  section: 'AP 6.12',
  group: 'registers',
  table: 'holding-register',
  items: 'many',
  access: 'writes',
  broadcast: true,
  request: layout([
    address('startAddress'),
    quantity('quantity', { ...limits, derive: lengthOf('registers') }),
    count('byteCount', {
      least: 2,
      most: bytesOfRegisters(limits.most),
      derive: lengthOf('registers', bytesOfRegisters),
      rules: [fitsQuantity(bytesOfRegisters)],
    }),
    registers('registers', ({ count }) => count),
  ]),
  response: layout([
    address('startAddress', [echoes('startAddress')]),
    quantity('quantity', { ...limits, replyRules: [echoes('quantity')] }),
  ]),
});
