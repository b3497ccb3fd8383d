import { layout } from '../field.ts';
import { address, bytesOfRegisters, count, even, fitsRequest, lengthOf, quantity } from '../fields/number.ts';
import { registers } from '../fields/registers.ts';

/** Most registers in one reply: 250 bytes (AP 6.3, AP 6.4, AP 6.17). */
export const MOST_REGISTERS_READ = 125;

/** What 03 and 04 ask: a start address and how many registers. */
export const readRegistersRequest = layout([
  address('startAddress'),
  quantity('quantity', { from: 'startAddress', least: 1, most: MOST_REGISTERS_READ }),
]);

/** What 03, 04 and 17 answer; `asked` names the request's field that says how many registers are expected. */
export const readRegistersResponse = (asked: string) =>
  layout([
    count('byteCount', {
      least: 2,
      most: bytesOfRegisters(MOST_REGISTERS_READ),
      derive: lengthOf('registers', bytesOfRegisters),
      rules: [even],
      replyRules: [fitsRequest(asked, bytesOfRegisters)],
    }),
    registers('registers', ({ count }) => count),
  ]);
