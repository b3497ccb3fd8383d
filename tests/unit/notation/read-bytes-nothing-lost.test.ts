import fc from 'fast-check';
import { expect, test } from 'vitest';
import { readBytes } from '../../../src/notation/index.ts';

const pair = fc.integer({ min: 0, max: 255 }).map((value) => value.toString(16).padStart(2, '0').toUpperCase());
const number = fc.integer({ min: 0, max: 255 }).map(String);
/** No separators of cells: a number in a cell of its own may count the bytes of the next. */
const words = [
  'value',
  'TX:',
  'reply',
  'Rx',
  'the',
  'with:',
  '//',
  '#',
  '->',
  'Processing:',
  'crc',
  'buffer:',
  '[INFO]',
];
const line = fc.array(fc.oneof({ weight: 3, arbitrary: pair }, number, fc.constantFrom(...words)), { maxLength: 12 });
const texts = fc.array(line, { maxLength: 5 }).map((lines) => lines.map((items) => items.join(' ')).join('\n'));

test('every number that may be a byte is read, or named as a problem in its place', () => {
  fc.assert(
    fc.property(texts, (text) => {
      const { origin, problems } = readBytes(text);
      const covered = new Uint8Array(text.length);
      for (const { start, end } of [...origin, ...problems]) covered.fill(1, start, end);
      for (const { 0: token, index } of text.matchAll(/(?<!\S)(?:[0-9A-F]{2}|\d{1,3})(?!\S)/g)) {
        expect([text, index, token, covered[index]]).toEqual([text, index, token, 1]);
      }
    }),
    { numRuns: 400 },
  );
});
