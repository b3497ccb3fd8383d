import { oneElement } from '../fields/number.ts';
import { defineFunction } from '../function-code.ts';
import { readRegistersRequest, readRegistersResponse } from './read-registers.ts';

export const readHoldingRegisters = defineFunction({
  code: 0x03,
  name: 'Read Holding Registers',
  section: 'AP 6.3',
  group: 'registers',
  table: 'holding-register',
  items: 'many',
  access: 'reads',
  probe: oneElement,
  request: readRegistersRequest,
  response: readRegistersResponse('quantity'),
});
