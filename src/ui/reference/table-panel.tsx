import { Component } from 'preact';
import type { ReferenceWords } from '../../words/index.ts';
import type { ReferenceSubject } from '../../workbench/index.ts';
import type { Entry, Section } from './entry.tsx';

const idOf = (subject: ReferenceSubject) => `table-${subject}`;

/** The heading of a table, which takes the focus so that reading goes on from there. */
export const headingOf = (subject: ReferenceSubject) => document.getElementById(idOf(subject));

/** A table under its heading, with the rows that a search has found. */
export function TablePanel(props: { section: Section; entries: readonly Entry[]; text: ReferenceWords }) {
  const { section, entries, text } = props;
  const { subject, columns } = section;
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
        <tbody>
          {entries.map((entry) => (
            <Row key={entry.key} entry={entry} columns={columns} />
          ))}
        </tbody>
      </table>
    </section>
  );
}

interface RowProps {
  readonly entry: Entry;
  readonly columns: readonly string[];
}

/** What a row says never changes: it is drawn once. */
class Row extends Component<RowProps> {
  override shouldComponentUpdate({ entry }: RowProps) {
    return entry !== this.props.entry;
  }

  render() {
    const { entry, columns } = this.props;
    const [head, ...cells] = entry.cells;
    return (
      <tr>
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
}
