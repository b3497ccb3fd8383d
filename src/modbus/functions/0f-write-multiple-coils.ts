import { layout } from '../field.ts';
import { bits } from '../fields/bits.ts';
import { address, bytesOfBits, count, echoes, fitsQuantity, lengthOf, quantity } from '../fields/number.ts';
import { defineFunction } from '../function-code.ts';

const limits = { from: 'startAddress', least: 1, most: 1968, oldLimit: 800 } as const;

export const writeMultipleCoils = defineFunction({
  code: 0x0f,
  name: 'Write Multiple Coils',
  section: 'AP 6.11',
  group: 'bits',
  table: 'coil',
  items: 'many',
  access: 'writes',
  broadcast: true,
  request: layout([
    address('startAddress'),
    quantity('quantity', { ...limits, derive: lengthOf('bits') }),
    count('byteCount', {
      least: 1,
      most: bytesOfBits(limits.most),
      derive: lengthOf('bits', bytesOfBits),
      rules: [fitsQuantity(bytesOfBits)],
    }),
    bits('bits', {
      size: ({ count }) => count,
      quantity: ({ items }) => items,
    }),
  ]),
  response: layout([
    address('startAddress', [echoes('startAddress')]),
    quantity('quantity', { ...limits, replyRules: [echoes('quantity')] }),
  ]),
});
