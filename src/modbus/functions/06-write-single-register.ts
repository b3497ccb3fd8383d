import { layout } from '../field.ts';
import { address, echoes, u16 } from '../fields/number.ts';
import { defineFunction } from '../function-code.ts';

const fields = layout([address('address', [echoes('address')]), u16('value', { replyRules: [echoes('value')] })]);

export const writeSingleRegister = defineFunction({
  code: 0x06,
  name: 'Write Single Register',
  section: 'AP 6.6',
  group: 'registers',
  table: 'holding-register',
  items: 'one',
  access: 'writes',
  broadcast: true,
  request: fields,
  response: fields,
});
