import { layout } from '../field.ts';
import { address, bytesOfRegisters, count, even, lengthOf } from '../fields/number.ts';
import { registers } from '../fields/registers.ts';
import { defineFunction } from '../function-code.ts';

/** More than 31 values in the queue and the server answers with exception 03 (AP 6.18). */
const MOST_VALUES = 31;
/** The byte count includes the FIFO count. */
const COUNT_BYTES = 2;

export const readFifoQueue = defineFunction({
  code: 0x18,
  name: 'Read FIFO Queue',
  section: 'AP 6.18',
  group: 'registers',
  table: 'holding-register',
  items: 'other',
  access: 'reads',
  probe: { fifoPointerAddress: 0 },
  request: layout([address('fifoPointerAddress')]),
  response: layout([
    count('byteCount', {
      width: 2,
      least: COUNT_BYTES,
      most: COUNT_BYTES + bytesOfRegisters(MOST_VALUES),
      derive: lengthOf('fifoValues', (values) => COUNT_BYTES + bytesOfRegisters(values)),
      rules: [even],
    }),
    count('fifoCount', {
      kind: 'quantity',
      width: 2,
      least: 0,
      most: MOST_VALUES,
      derive: lengthOf('fifoValues'),
      rules: [
        (got, seen) => {
          const expected = (seen.count - COUNT_BYTES) / 2;
          // A byte count that makes no whole number of values is itself what is wrong.
          return got === expected || !Number.isInteger(expected) || expected < 0
            ? undefined
            : { code: 'count-wrong', severity: 'error', got, expected };
        },
      ],
    }),
    registers('fifoValues', ({ count }) => Math.max(0, count - COUNT_BYTES)),
  ]),
});
