import { layout } from '../field.ts';
import { u8 } from '../fields/number.ts';
import { defineFunction } from '../function-code.ts';

/** Exception codes and their official names (AP 7); 07 stands in PI App. A only. */
export const exceptionCodes = [
  { code: 0x01, name: 'ILLEGAL FUNCTION' },
  { code: 0x02, name: 'ILLEGAL DATA ADDRESS' },
  { code: 0x03, name: 'ILLEGAL DATA VALUE' },
  { code: 0x04, name: 'SERVER DEVICE FAILURE' },
  { code: 0x05, name: 'ACKNOWLEDGE' },
  { code: 0x06, name: 'SERVER DEVICE BUSY' },
  { code: 0x07, name: 'NEGATIVE ACKNOWLEDGE' },
  { code: 0x08, name: 'MEMORY PARITY ERROR' },
  { code: 0x0a, name: 'GATEWAY PATH UNAVAILABLE' },
  { code: 0x0b, name: 'GATEWAY TARGET DEVICE FAILED TO RESPOND' },
] as const;

const PI_ONLY = 0x07;
const known = new Set<number>(exceptionCodes.map(({ code }) => code));

/** The reply of every function that was refused: its code + 80, and one byte that says why. */
export const exception = defineFunction({
  code: 0x80,
  name: 'Exception',
  section: 'AP 7',
  group: 'other',
  // It is never a request: the safe answer.
  access: 'writes',
  request: layout([]),
  response: layout([
    u8('exceptionCode', {
      kind: 'choice',
      allowed: [...known],
      rules: [
        (got) => (known.has(got) ? undefined : { code: 'exception-undefined', severity: 'warning', got }),
        (got) => (got === PI_ONLY ? { code: 'exception-pi-only', severity: 'note', section: 'PI App. A' } : undefined),
      ],
    }),
  ]),
});
