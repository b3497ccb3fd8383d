import { expect, it } from 'vitest';
import { writeTableText } from '../../../src/notation/index.ts';

const rows = [
  ['Speed', 't3.5, µs'],
  ['9600', '4010.417'],
  ['a|b', 'say "so"'],
];

it('writes a table for a spreadsheet, a forum and a file', () => {
  expect(writeTableText(rows, 'tsv')).toBe('Speed\tt3.5, µs\n9600\t4010.417\na|b\tsay "so"');
  expect(writeTableText(rows, 'markdown')).toBe(
    '| Speed | t3.5, µs |\n| --- | --- |\n| 9600 | 4010.417 |\n| a\\|b | say "so" |',
  );
  expect(writeTableText(rows, 'csv')).toBe('Speed,"t3.5, µs"\n9600,4010.417\na|b,"say ""so"""');
});
