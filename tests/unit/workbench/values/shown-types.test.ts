import { expect, test } from 'vitest';
import { readExpected, valuesAt } from '../../../../src/notation/index.ts';
import { shownViews } from '../../../../src/workbench/values/shown-types.ts';

const types = (registers: readonly number[], rare: boolean, expected?: string) => [
  ...new Set(
    shownViews(valuesAt(registers, expected === undefined ? undefined : readExpected(expected)), rare).map(
      ({ type }) => type,
    ),
  ),
];

test('texts are shown only where there is text', () => {
  // "PU".
  expect(types([0x5055], false)).toContain('text');
  expect(types([0x0001], false)).not.toContain('text');
});

test('half floats and BCD are shown only if they are asked for', () => {
  expect(types([0x0001], false)).toEqual(['u16', 'i16', 'bits']);
  expect(types([0x0001], true)).toEqual(['u16', 'i16', 'f16', 'bcd16', 'bits']);
});

test('a rare type is shown where it has the value that is expected', () => {
  // BCD 1234.
  expect(types([0x1234], false, '1234')).toEqual(expect.arrayContaining(['bcd16']));
  expect(types([0x1234], false, '99')).not.toContain('bcd16');
});
