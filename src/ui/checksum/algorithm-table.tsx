import { Component } from 'preact';
import { polynomialForms } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import {
  type AlgorithmRow,
  finder,
  registerHex,
  type Sort,
  type SortKey,
  sortedRows,
  sortKeys,
  valueBytes,
} from '../../workbench/index.ts';
import { checksumWords as words } from './checksum-words.ts';
import { CopiedValue } from './copied-value.tsx';

interface TableProps {
  readonly rows: readonly AlgorithmRow[];
  readonly chosen: string;
  readonly computing: boolean;
  readonly search: string;
  readonly sort: Sort | undefined;
  readonly onSearch: (search: string) => void;
  readonly onSort: (sort: Sort | undefined) => void;
  readonly onChoose: (row: AlgorithmRow) => void;
  readonly onLeave: () => void;
}

const ID = 'checksum-search';
const COLUMNS = Object.keys(sortKeys) as readonly SortKey[];

/** What the table depends on: everything but the handlers. */
const SHOWN = ['rows', 'chosen', 'computing', 'search', 'sort'] as const;

/** Every algorithm over the input, found as one types, in the order of any column. */
export class AlgorithmTable extends Component<TableProps> {
  /** While a file is read, the view is drawn for its progress many times a second. */
  override shouldComponentUpdate(next: TableProps) {
    return SHOWN.some((name) => next[name] !== this.props[name]);
  }

  render() {
    const { props } = this;
    const { rows, search, sort, chosen } = props;
    const finds = finder(search);
    const found = sortedRows(rows, sort).filter(finds);
    return (
      <section class="panel algorithms" aria-labelledby={`${ID}-title`}>
        <div class="algorithms-head">
          <h2 id={`${ID}-title`}>{words.all}</h2>
          <search>
            <label for={ID}>{words.search}</label>
            <input
              id={ID}
              type="search"
              value={search}
              placeholder={words.searchHint}
              autocomplete="off"
              spellcheck={false}
              autocapitalize="off"
              onInput={({ currentTarget }) => props.onSearch(currentTarget.value)}
              onFocusOut={props.onLeave}
            />
            <output for={ID}>{words.shown(found.length, rows.length)}</output>
          </search>
        </div>
        {found.length === 0 ? (
          <p>
            {words.nothing(search.trim())}{' '}
            <button
              type="button"
              onClick={() => {
                props.onSearch('');
                document.getElementById(ID)?.focus();
              }}
            >
              {words.clearSearch}
            </button>
          </p>
        ) : (
          <table aria-labelledby={`${ID}-title`} aria-busy={props.computing}>
            <thead>
              <tr>
                {COLUMNS.map((column) => (
                  <Head key={column} column={column} sort={sort} onSort={props.onSort} />
                ))}
              </tr>
            </thead>
            <tbody>
              {found.map((row) => (
                <Line
                  key={row.key}
                  row={row}
                  chosen={row.key === chosen}
                  computing={props.computing}
                  onChoose={props.onChoose}
                />
              ))}
            </tbody>
          </table>
        )}
      </section>
    );
  }
}

interface HeadProps {
  readonly column: SortKey;
  readonly sort: Sort | undefined;
  readonly onSort: (sort: Sort | undefined) => void;
}

/** Sorts by its column; pressed again, the other way round; pressed a third time, in the order of the catalogue. */
function Head({ column, sort, onSort }: HeadProps) {
  const by = sort?.by === column ? sort : undefined;
  const next = by === undefined ? { by: column, down: false } : by.down ? undefined : { by: column, down: true };
  return (
    <th scope="col" aria-sort={by && (by.down ? 'descending' : 'ascending')}>
      <button type="button" onClick={() => onSort(next)}>
        {words.columns[column]}
        <span aria-hidden="true">{by && (by.down ? ' ▾' : ' ▴')}</span>
      </button>
    </th>
  );
}

interface LineProps {
  readonly row: AlgorithmRow;
  readonly chosen: boolean;
  readonly computing: boolean;
  readonly onChoose: (row: AlgorithmRow) => void;
}

function Line({ row, chosen, computing, onChoose }: LineProps) {
  const { checksum, name, value } = row;
  const { width, aliases, crc, check } = checksum;
  const hex = (number: number) => registerHex(width, number);
  const forms = crc && polynomialForms(crc);
  return (
    <tr data-chosen={chosen ? '' : undefined}>
      <th scope="row">
        <label>
          <input type="radio" name="algorithm" checked={chosen} onChange={() => onChoose(row)} /> {name}
        </label>
        {aliases.length > 0 && <small>{aliases.join(', ')}</small>}
      </th>
      <td data-column={words.columns.value}>
        {value === undefined ? (
          <span class="said">{computing ? words.computing : words.chooseIt}</span>
        ) : (
          <>
            <CopiedValue text={hex(value)} of={name} />
            {width > 8 && (
              <small class="mono" title={words.bothOrders}>
                {formatBytes(valueBytes(value, width))} · {formatBytes(valueBytes(value, width).toReversed())}
              </small>
            )}
          </>
        )}
      </td>
      <td data-column={words.columns.width}>{width}</td>
      <td data-column={words.columns.poly} class="mono">
        {forms ? hex(forms.normal) : words.noCrc}
      </td>
      <td data-column={words.columns.reversed} class="mono">
        {forms && hex(forms.reversed)}
      </td>
      <td data-column={words.columns.koopman} class="mono">
        {forms && hex(forms.koopman)}
      </td>
      <td data-column={words.columns.init} class="mono">
        {crc && hex(crc.init)}
      </td>
      <td data-column={words.columns.reflected}>{crc && words.reflections(crc.refin, crc.refout)}</td>
      <td data-column={words.columns.xorout} class="mono">
        {crc && hex(crc.xorout)}
      </td>
      <td data-column={words.columns.check} class="mono">
        {hex(check)}
      </td>
      <td data-column={words.columns.residue} class="mono">
        {crc && hex(crc.residue)}
      </td>
    </tr>
  );
}
