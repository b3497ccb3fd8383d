import { layout } from '../field.ts';
import { choice, u16 } from '../fields/number.ts';
import { defineFunction } from '../function-code.ts';

/** FFFF: a program command issued before is still being executed; 0000: there is no such command (AP 6.9). */
export const COMM_STATUS = [0x0000, 0xffff] as const;

export const getCommEventCounter = defineFunction({
  code: 0x0b,
  name: 'Get Comm Event Counter',
  section: 'AP 6.9',
  group: 'diagnostics',
  access: 'reads',
  probe: {},
  serialOnly: true,
  request: layout([]),
  response: layout([choice('status', COMM_STATUS, { width: 2 }), u16('eventCount')]),
});
