import { layout } from '../field.ts';
import { coil } from '../fields/bits.ts';
import { address, echoes } from '../fields/number.ts';
import { defineFunction } from '../function-code.ts';

const fields = layout([address('address', [echoes('address')]), coil('value')]);

export const writeSingleCoil = defineFunction({
  code: 0x05,
  name: 'Write Single Coil',
  section: 'AP 6.5',
  group: 'bits',
  table: 'coil',
  items: 'one',
  access: 'writes',
  broadcast: true,
  request: fields,
  response: fields,
});
