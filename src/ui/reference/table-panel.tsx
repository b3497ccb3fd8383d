import type { VNode } from 'preact';
import type { ReferenceSubject } from '../../workbench/index.ts';
import { useWords } from '../parts/words.ts';
import type { Entry } from './entry.tsx';

const idOf = (subject: ReferenceSubject) => `table-${subject}`;

/** The heading of a table, which takes the focus so that reading goes on from there. */
export const headingOf = (subject: ReferenceSubject) => document.getElementById(idOf(subject));

interface PanelProps {
  readonly subject: ReferenceSubject;
  readonly columns: readonly string[];
  readonly rows: readonly VNode[];
}

/** A table under its heading, with the rows that a search has found. */
export function TablePanel({ subject, columns, rows }: PanelProps) {
  const text = useWords('reference');
  return (
    <section class="panel" aria-labelledby={idOf(subject)}>
      <h2 id={idOf(subject)} tabIndex={-1}>
        {text.subjects[subject]}
      </h2>
      <p class="introduction">{text.introductions[subject]}</p>
      <table aria-labelledby={idOf(subject)} data-subject={subject}>
        <thead>
          <tr>
            {columns.map((column) => (
              <th key={column} scope="col">
                {column}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>{rows}</tbody>
      </table>
    </section>
  );
}

/** The row of an entry. Made once, so that it is drawn once: what it says never changes. */
export function rowOf({ key, cells: [head, ...cells] }: Entry, columns: readonly string[]): VNode {
  return (
    <tr key={key}>
      <th scope="row">{head}</th>
      {cells.map((cell, index) => (
        // Where the columns do not fit side by side, each cell names its own.
        <td key={columns[index + 1]} data-column={columns[index + 1]}>
          {cell}
        </td>
      ))}
    </tr>
  );
}
