import { oneElement } from '../fields/number.ts';
import { defineFunction } from '../function-code.ts';
import { readBitsRequest, readBitsResponse } from './read-bits.ts';

export const readDiscreteInputs = defineFunction({
  code: 0x02,
  name: 'Read Discrete Inputs',
  section: 'AP 6.2',
  group: 'bits',
  table: 'discrete-input',
  items: 'many',
  access: 'reads',
  probe: oneElement,
  request: readBitsRequest,
  response: readBitsResponse,
});
