import { layout } from '../field.ts';
import { u8 } from '../fields/number.ts';
import { defineFunction } from '../function-code.ts';

export const readExceptionStatus = defineFunction({
  code: 0x07,
  name: 'Read Exception Status',
  section: 'AP 6.7',
  group: 'diagnostics',
  access: 'reads',
  probe: {},
  serialOnly: true,
  request: layout([]),
  response: layout([u8('outputData')]),
});
