import { oneElement } from '../fields/number.ts';
import { defineFunction } from '../function-code.ts';
import { readBitsRequest, readBitsResponse } from './read-bits.ts';

export const readCoils = defineFunction({
  code: 0x01,
  name: 'Read Coils',
  section: 'AP 6.1',
  group: 'bits',
  table: 'coil',
  items: 'many',
  access: 'reads',
  probe: oneElement,
  request: readBitsRequest,
  response: readBitsResponse,
});
