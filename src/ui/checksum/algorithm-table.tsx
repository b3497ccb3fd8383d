import type { ComponentChildren } from 'preact';
import { polynomialForms } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import type { ChecksumView } from '../../store/index.ts';
import { type AlgorithmRow, registerHex, type SortKey, sortKeys, valueBytes } from '../../workbench/index.ts';
import { SearchBox } from '../kit/search-box.tsx';
import { SortSelect, sortHead, Table } from '../kit/table.tsx';
import type { ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import { CopiedValue } from './copied-value.tsx';

const ID = 'checksum-search';
const COLUMNS = Object.keys(sortKeys) as readonly SortKey[];
const AS_TEXT: ReadonlySet<SortKey> = new Set(['name', 'value', 'width', 'reflected']);

/** Every algorithm over the input, found as one types, in the order of any column. */
export function AlgorithmTable({ view }: ViewProps<ChecksumView>) {
  const words = useWords('checksum');
  const search = view.search.value;
  const sort = view.sort.value;
  const found = view.found.value;
  const chosen = view.chosen.value.name;
  const columns = COLUMNS.map((column) => ({
    ...sortHead(column, words.columns[column], sort, (next) => view.change({ sort: next })),
    ...(AS_TEXT.has(column) ? {} : { class: 'mono' }),
    cell: (row: AlgorithmRow) => <Cell view={view} column={column} row={row} />,
  }));
  return (
    <div class="algorithms">
      <div class="algorithms-head in-row">
        <SearchBox
          id={ID}
          label={words.search}
          text={search}
          hint={words.searchHint}
          found={words.shown(found.length, view.rows.value.length)}
          onText={(typed) => view.change({ search: typed })}
        />
        <SortSelect
          label={words.order}
          unsorted={words.unsorted}
          columns={COLUMNS}
          names={words.columns}
          sort={sort}
          onSort={(next) => view.change({ sort: next })}
        />
      </div>
      {found.length === 0 ? (
        <p>
          {words.nothing(search.trim())}{' '}
          <button
            type="button"
            onClick={() => {
              view.change({ search: '' });
              document.getElementById(ID)?.focus();
            }}
          >
            {words.clearSearch}
          </button>
        </p>
      ) : (
        <Table
          label={words.all}
          columns={columns}
          rows={found}
          keyOf={({ key }) => key}
          attributes={({ key }) => ({ 'data-chosen': key === chosen ? '' : undefined })}
          narrow="cards many"
          busy={view.computing.value}
        />
      )}
    </div>
  );
}

interface CellProps extends ViewProps<ChecksumView> {
  readonly column: SortKey;
  readonly row: AlgorithmRow;
}

function Cell({ view, column, row }: CellProps): ComponentChildren {
  const words = useWords('checksum');
  const { checksum, name, value, key } = row;
  const { width, aliases, crc, check } = checksum;
  const hex = (number: number) => registerHex(width, number);
  switch (column) {
    case 'name':
      return (
        <>
          <label>
            <input
              type="radio"
              name="algorithm"
              checked={key === view.chosen.value.name}
              onChange={() => view.choose(key)}
            />{' '}
            {name}
          </label>
          {aliases.length > 0 && <small>{aliases.join(', ')}</small>}
        </>
      );
    case 'value':
      if (value === undefined)
        return <span class="said">{view.computing.value ? words.computing : words.chooseIt}</span>;
      return (
        <>
          <CopiedValue text={hex(value)} of={name} />
          {width > 8 && (
            <small class="mono" title={words.bothOrders}>
              {formatBytes(valueBytes(value, width))} · {formatBytes(valueBytes(value, width).toReversed())}
            </small>
          )}
        </>
      );
    case 'width':
      return width;
    case 'check':
      return hex(check);
    case 'poly':
      return crc ? hex(crc.poly) : words.noCrc;
    case 'reflected':
      return crc && words.reflections(crc.refin, crc.refout);
    case 'reversed':
    case 'koopman':
      return crc && hex(polynomialForms(crc)[column]);
    default:
      return crc && hex(crc[column]);
  }
}
