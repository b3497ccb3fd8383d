import { oneElement } from '../fields/number.ts';
import { defineFunction } from '../function-code.ts';
import { readRegistersRequest, readRegistersResponse } from './read-registers.ts';

export const readInputRegisters = defineFunction({
  code: 0x04,
  name: 'Read Input Registers',
  section: 'AP 6.4',
  group: 'registers',
  table: 'input-register',
  items: 'many',
  access: 'reads',
  probe: oneElement,
  request: readRegistersRequest,
  response: readRegistersResponse('quantity'),
});
