import { writeTableText } from '../../notation/index.ts';
import { type Explained, type ExplanationRow, explain } from './explanation.ts';

/** How the explanation is copied as text. */
export type ExplanationForm = 'markdown' | 'table';

/** What the columns of the explanation are called. */
export type ExplanationColumns = Readonly<Record<'byte' | 'hex' | 'decimal' | 'bits' | 'means' | 'section', string>>;

/** The explanation as a table: tab-separated for a spreadsheet, or Markdown for a forum. */
export function explanationText(of: Explained, columns: ExplanationColumns, as: ExplanationForm): string {
  const head = [columns.byte, columns.hex, columns.decimal, columns.bits, columns.means, columns.section];
  return writeTableText([head, ...explain(of).map(cellsOf)], as === 'table' ? 'tsv' : as);
}

const cellsOf = ({ offset, hex, decimal, bits, label, name, meaning, problems, section }: ExplanationRow): string[] => [
  offset,
  hex,
  decimal,
  bits,
  [label && `${label}.`, name, meaning, problems.replaceAll('\n', ' ')].filter((part) => part !== '').join(' '),
  section,
];
