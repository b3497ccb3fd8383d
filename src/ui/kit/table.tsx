import type { ComponentChildren, HTMLAttributes } from 'preact';
import { Select } from './choice.tsx';
import { Copying } from './copy-button.tsx';
import './table.css';

interface Column<Row> {
  readonly name: string;
  /** What stands in the head, if it is more than the name, such as a button that sorts. */
  readonly head?: ComponentChildren;
  readonly sorted?: 'ascending' | 'descending' | undefined;
  /** `mono` for digits, `number` for numbers that are compared. */
  readonly class?: string;
  readonly cell: (row: Row, index: number) => ComponentChildren;
}

interface Sort<C> {
  readonly by: C;
  readonly down: boolean;
}

/** The head of a column that sorts: pressed again, the other way round; pressed a third time, the rows have their own order. */
export function sortHead<C extends string>(
  column: C,
  name: string,
  sort: Sort<C> | undefined,
  onSort: (sort: Sort<C> | undefined) => void,
): Pick<Column<unknown>, 'name' | 'head' | 'sorted'> {
  const by = sort?.by === column ? sort : undefined;
  const next = by === undefined ? { by: column, down: false } : by.down ? undefined : { by: column, down: true };
  return {
    name,
    head: (
      <button type="button" onClick={() => onSort(next)}>
        {name}
        <span aria-hidden="true">{by && (by.down ? ' ▾' : ' ▴')}</span>
      </button>
    ),
    sorted: by && (by.down ? 'descending' : 'ascending'),
  };
}

interface SortSelectProps<C extends string> {
  readonly label: string;
  /** The order of the rows if they are not sorted. */
  readonly unsorted: string;
  readonly columns: readonly C[];
  readonly names: Readonly<Record<C, string>>;
  readonly sort: Sort<C> | undefined;
  readonly onSort: (sort: Sort<C> | undefined) => void;
}

/** What sorts where the rows are cards and their columns have no heads. */
export const SortSelect = <C extends string>(props: SortSelectProps<C>) => {
  const { label, unsorted, columns, names, sort, onSort } = props;
  return (
    <label class="order">
      {label}{' '}
      <Select
        value={sort?.by ?? ''}
        options={[
          { value: '' as const, name: unsorted },
          ...columns.map((column) => ({ value: column, name: names[column] })),
        ]}
        onChoose={(by) => onSort(by === '' ? undefined : { by, down: false })}
      />
    </label>
  );
};

interface CopyAsProps<Format extends string> {
  readonly label: string;
  /** What stands before the choice of the format. */
  readonly as: string;
  readonly formats: Readonly<Record<Format, string>>;
  readonly format: Format;
  readonly onFormat: (format: Format) => void;
  /** The table as a text. */
  readonly text: (format: Format) => string;
  readonly copied: string;
  readonly refused: (text: string) => string;
}

/** A button that copies a text in a format of one's choice, and what became of it. */
export function CopyAs<F extends string>(props: CopyAsProps<F>) {
  const { label, as, formats, format, onFormat, text, copied, refused } = props;
  return (
    <div class="actions">
      <Copying copied={copied} refused={refused} of={format}>
        {(copy) => (
          <>
            <button type="button" onClick={copy(() => text(format))}>
              {label}
            </button>
            <label>
              {as}{' '}
              <Select
                value={format}
                options={Object.entries<string>(formats).map(([value, name]) => ({ value: value as F, name }))}
                onChoose={onFormat}
              />
            </label>
          </>
        )}
      </Copying>
    </div>
  );
}

type RowAttributes = HTMLAttributes<HTMLTableRowElement> & Readonly<Record<`data-${string}`, string | undefined>>;

interface TableProps<Row, F extends string> {
  readonly class?: string;
  /** Its name, if it has neither a caption nor a heading. */
  readonly label?: string;
  /** The id of its heading. */
  readonly labelledBy?: string;
  readonly caption?: string;
  /** The first column is the head of its row. */
  readonly columns: readonly Column<Row>[];
  readonly rows: readonly Row[];
  readonly keyOf: (row: Row, index: number) => string | number;
  /** Attributes of a row. */
  readonly attributes?: (row: Row, index: number) => RowAttributes;
  /**
   * What is done where the columns have no room: `cards` sets each row as a block whose cells name their columns, at a width
   * of 560 px or, for many columns, of 800; `scroll` scrolls the table sideways.
   */
  readonly narrow?: 'cards' | 'cards many' | 'scroll';
  readonly busy?: boolean;
  readonly copyAs?: CopyAsProps<F>;
}

/** Rows of the same columns. */
export function Table<Row, F extends string = string>(props: TableProps<Row, F>) {
  const { class: given, label, labelledBy, caption, columns, rows, keyOf, attributes, narrow, busy, copyAs } = props;
  const [first, ...others] = columns;
  return (
    <>
      <div
        class={`table ${narrow ?? ''}`}
        // What scrolls must be reached by keys.
        {...(narrow === 'scroll' ? { tabIndex: 0, role: 'group', 'aria-label': label ?? caption } : {})}
      >
        <table class={given} aria-label={label} aria-labelledby={labelledBy} aria-busy={busy}>
          {caption !== undefined && <caption>{caption}</caption>}
          <thead>
            <tr>
              {columns.map(({ name, head = name, sorted }) => (
                <th key={name} scope="col" aria-sort={sorted}>
                  {head}
                </th>
              ))}
            </tr>
          </thead>
          <tbody>
            {rows.map((row, index) => (
              <tr {...attributes?.(row, index)} key={keyOf(row, index)}>
                {first && (
                  <th scope="row" class={first.class}>
                    {first.cell(row, index)}
                  </th>
                )}
                {others.map(({ name, class: of, cell }) => (
                  <td key={name} class={of} data-column={name}>
                    {cell(row, index)}
                  </td>
                ))}
              </tr>
            ))}
          </tbody>
        </table>
      </div>
      {copyAs && <CopyAs {...copyAs} />}
    </>
  );
}
