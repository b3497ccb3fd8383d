import { expect, test } from 'vitest';
import { entityNumber } from '../../../src/notation/index.ts';

test.each([
  ['coil', 0, '00001'],
  ['coil', 9998, '09999'],
  ['coil', 9999, '010000'],
  ['coil', 65535, '065536'],
  ['discrete-input', 0, '10001'],
  ['discrete-input', 196, '10197'],
  ['input-register', 8, '30009'],
  ['input-register', 65535, '365536'],
  ['holding-register', 107, '40108'],
  ['holding-register', 0x04de, '41247'],
  ['holding-register', 9998, '49999'],
  ['holding-register', 9999, '410000'],
] as const)('%s %i is %s (PI ch. 2)', (table, address, number) => {
  expect(entityNumber(table, address)).toBe(number);
});

test('records of extended memory are counted from 0, in six digits (PI fn 20)', () => {
  expect(entityNumber('file-record', 0)).toBe('600000');
  expect(entityNumber('file-record', 107)).toBe('600107');
  expect(entityNumber('file-record', 9999)).toBe('609999');
});
