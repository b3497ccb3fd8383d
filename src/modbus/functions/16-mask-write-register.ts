import { layout } from '../field.ts';
import { address, echoes, u16 } from '../fields/number.ts';
import { defineFunction } from '../function-code.ts';

const fields = layout([
  address('referenceAddress', [echoes('referenceAddress')]),
  u16('andMask', { replyRules: [echoes('andMask')] }),
  u16('orMask', { replyRules: [echoes('orMask')] }),
]);

/** The register becomes (current AND andMask) OR (orMask AND NOT andMask). */
export const maskWriteRegister = defineFunction({
  code: 0x16,
  name: 'Mask Write Register',
  section: 'AP 6.16',
  group: 'registers',
  table: 'holding-register',
  items: 'other',
  access: 'writes',
  request: fields,
  response: fields,
});
