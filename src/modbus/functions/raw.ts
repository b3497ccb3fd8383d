import { layout } from '../field.ts';
import { hex } from '../fields/raw-bytes.ts';
import { defineFunction } from '../function-code.ts';

const data = layout([hex('data')]);

/** Every code whose layout the specification does not give: all that follows is raw data. */
export const rawFunction = defineFunction({
  code: 0x00,
  name: 'Raw data',
  section: 'AP 5',
  group: 'other',
  // Nobody knows what it does: the safe answer.
  access: 'writes',
  request: data,
  response: data,
});
