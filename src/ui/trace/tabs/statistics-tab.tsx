import type { ComponentChildren } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { nameAt } from '../../../devices/index.ts';
import { describeFunction } from '../../../modbus/index.ts';
import { entityNumber, type TableFormat } from '../../../notation/index.ts';
import type { Tallies } from '../../../store/index.ts';
import type { Tallied, Tally } from '../../../trace/index.ts';
import {
  filterOfTally,
  type TallyColumn,
  type TallySort,
  talliesText,
  tallyColumns,
  tallyValue,
} from '../../../workbench/index.ts';
import { Segments } from '../../kit/segments.tsx';
import { sortHead, Table } from '../../kit/table.tsx';
import { device } from '../../parts/device/naming.ts';
import { useWords } from '../../parts/words.ts';
import { Counting, OfWholeLog, type TraceTabProps, useSome } from './trace-tab.tsx';

const TEXTS: ReadonlySet<TallyColumn> = new Set(['functionCode', 'connection', 'faults']);

/** How many exchanges there are of each kind, how they went, and how quick the replies were. */
export function StatisticsTab({ of, open, toRows }: TraceTabProps) {
  const words = useWords('trace').tabs;
  const { statistics } = words;
  const [by, setBy] = useState<Tallied>('unit');
  const [sort, setSort] = useState<TallySort>();
  useEffect(() => {
    if (open) of.tabs.want({ kind: 'statistics', by, sort });
  }, [of, open, by, sort]);
  const { value: counted } = of.tabs.tallies;
  const choose = (next: Tallied) => {
    setBy(next);
    setSort(undefined);
  };
  const options = Object.entries(statistics.byNames).map(([value, name]) => ({ value: value as Tallied, name }));
  return (
    <>
      <Segments label={statistics.by} options={options} value={by} onChoose={choose} />
      {counted?.by === by ? (
        <TallyTable
          key={by}
          by={by}
          counted={counted}
          sort={sort}
          onSort={setSort}
          onRow={(tally) => {
            of.setFilter(filterOfTally(of.filter.peek(), tally));
            toRows();
          }}
        />
      ) : (
        <Counting />
      )}
      <OfWholeLog of={of} />
    </>
  );
}

interface TallyTableProps {
  readonly by: Tallied;
  readonly counted: Tallies;
  readonly sort: TallySort | undefined;
  readonly onSort: (sort: TallySort | undefined) => void;
  readonly onRow: (tally: Tally) => void;
}

function TallyTable({ by, counted, sort, onSort, onRow }: TallyTableProps) {
  const { statistics: words } = useWords('trace').tabs;
  const [format, setFormat] = useState<TableFormat>('csv');
  const { rows, count } = counted;
  const { shown, more } = useSome(rows);
  const columns = tallyColumns(by).map((column, at) => {
    const { head, ...sorting } = sortHead(column, words.columns[column], sort, onSort);
    const isText = TEXTS.has(column);
    return {
      ...sorting,
      head: isText ? head : <div class="number">{head}</div>,
      class: isText ? column : 'number',
      cell: (tally: Tally) => {
        const cell = <Cell column={column} tally={tally} />;
        return at > 0 ? (
          cell
        ) : (
          <button
            type="button"
            class="to-rows"
            title={words.showRows(words.columns[column])}
            onClick={() => onRow(tally)}
          >
            {cell}
          </button>
        );
      },
    };
  });
  return (
    <>
      <Table
        class="trace-tallies"
        label={words.byNames[by]}
        columns={columns}
        rows={shown}
        keyOf={({ unit, functionCode, address, quantity, connection }) =>
          [unit, functionCode, address, quantity, connection].join()
        }
        narrow="scroll"
        copyAs={{
          label: words.copy,
          as: words.as,
          formats: words.formats,
          format,
          onFormat: setFormat,
          text: (as) => talliesText(by, rows, words, as),
          copied: words.copied,
          refused: words.refused,
        }}
      />
      {more}
      {count > rows.length && <p class="said">{words.firstOf(rows.length, count)}</p>}
    </>
  );
}

function Cell({ column, tally }: { readonly column: TallyColumn; readonly tally: Tally }): ComponentChildren {
  const trace = useWords('trace');
  const { statistics: words } = trace.tabs;
  const value = tallyValue(tally, column);
  switch (column) {
    case 'faults':
      return words.faults(tally);
    case 'functionCode':
      return tally.functionCode !== undefined && words.functionName(tally.functionCode);
    case 'address':
      return <Place tally={tally} />;
    case 'connection':
      return value ?? words.noConnection;
    case 'unit':
      return value;
    case 'quantity':
    case 'exchanges':
    case 'replies':
      return typeof value === 'number' && words.number(value);
    default:
      return typeof value === 'number' && trace.duration(value);
  }
}

/** An address by the number of manuals, and what the device calls it. */
function Place({ tally: { functionCode = 0, address } }: { readonly tally: Tally }) {
  if (address === undefined) return null;
  const { table } = describeFunction(functionCode, 'request');
  if (table === undefined || table === 'file-record') return <>{address}</>;
  const name = device.value && nameAt(device.value, table, address);
  return (
    <>
      {entityNumber(table, address)} {name !== undefined && <small>{name}</small>}
    </>
  );
}
