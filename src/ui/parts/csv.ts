import papa from 'papaparse';
import type { ParsedRow } from '../../workbench/index.ts';

/** The rows of a CSV text, each with its end and whether a quote in it is not closed. */
export function parseCsv(text: string, delimiter: string): readonly ParsedRow[] {
  const parsed: ParsedRow[] = [];
  papa.parse(text, {
    delimiter,
    step: ({ data, errors, meta }) => {
      parsed.push({ cells: data, open: errors.some(({ type }) => type === 'Quotes'), end: meta.cursor });
    },
  });
  return parsed;
}
