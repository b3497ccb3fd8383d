import type { ComponentChildren, VNode } from 'preact';
import type { Section as SpecSection } from '../../modbus/index.ts';
import type { WordsOf } from '../../words/index.ts';
import { evaluate, type ReferenceFrame, referenceDraft, type Searchable, writeLink } from '../../workbench/index.ts';

/** What the tables are written with: the sentences of the reference, and those of the page. */
export interface Say {
  readonly text: WordsOf<'reference'>;
  readonly page: WordsOf<'page'>;
}

/** A row of the reference. */
export interface Entry {
  readonly key: string;
  /** The cells in the order of the columns; the first heads the row. Made of elements only, so that `textOf` reads them. */
  readonly cells: readonly ComponentChildren[];
  /** The codes it is found by. */
  readonly codes?: Searchable['codes'];
  /** What it is found by that no cell shows. */
  readonly also?: string;
}

/** A link that opens a frame; `label` where the text alone does not say which. */
export function frameLink(frame: ReferenceFrame, text: ComponentChildren, label?: string) {
  const draft = referenceDraft(frame);
  return (
    <a href={`#${writeLink(draft, evaluate(draft).controls)}`} aria-label={label}>
      {text}
    </a>
  );
}

/** A code as a table shows it: the digits of a frame, and something beside them. */
export const codeCell = (digits: string, beside?: string | number) => (
  <>
    <b class="mono">{digits}</b>
    {beside !== undefined && <small>{beside}</small>}
  </>
);

/** Where the specification says so. */
export const sectionCell = ({ page }: Say, ...sections: readonly SpecSection[]) => (
  <span class="section">{sections.map(page.section).join(', ')}</span>
);

/** What a search looks through: what the row shows, and what else it is found by. */
export const searchableOf = ({ cells, codes = [], also = '' }: Entry, others: string): Searchable => ({
  text: [...cells.map(textOf), also, others].join(' '),
  codes,
});

/** The text of a cell: what is shown is what is found. */
function textOf(cell: ComponentChildren): string {
  if (typeof cell === 'string' || typeof cell === 'number') return String(cell);
  if (Array.isArray(cell)) return cell.map(textOf).join(' ');
  return isElement(cell) ? textOf(cell.props.children) : '';
}

const isElement = (cell: ComponentChildren): cell is VNode<{ children?: ComponentChildren }> =>
  typeof cell === 'object' && cell !== null && 'props' in cell;
