import type { ComponentChildren } from 'preact';
import { fromHex } from '../../../modbus/index.ts';
import { formatBytes } from '../../../notation/index.ts';
import type { TraceView } from '../../../store/index.ts';
import { type TraceRow, traceSeverity } from '../../../workbench/index.ts';
import { VirtualList } from '../../kit/virtual-list.tsx';
import { useCommand } from '../commands.ts';
import { useWords } from '../words.ts';
import { MarkStrip } from './mark-strip.tsx';
import { timeKind, timeText } from './row-time.ts';
import './trace-rows.css';

/** In a narrower list, in pixels, a row has two lines. */
const NARROW = 960;
const COLUMNS = ['number', 'time', 'gap', 'side', 'unit', 'function', 'means', 'after', 'mark', 'hex'] as const;

interface RowsProps {
  readonly of: TraceView<File>;
  /** Keeps the last row in sight while rows are added. */
  readonly follow?: boolean;
}

/** The frames of a trace, one a row, or its exchanges: only those in sight are drawn. */
export function TraceRows({ of, follow = false }: RowsProps) {
  const words = useWords('trace');
  of.revision.value;
  useCommand('next-fault', of.nextFault);
  useCommand('previous-fault', of.previousFault);
  return (
    <div class="trace-rows-frame">
      <div class="trace-head" aria-hidden="true">
        {COLUMNS.map((column) => (
          <span key={column} class={column}>
            {column === 'side' ? '' : words.columns[column]}
          </span>
        ))}
      </div>
      <VirtualList
        id="trace"
        class="trace-rows"
        label={words.rows(of.rowsKept.value, of.piecesKept.value, of.by.value)}
        breaksBelow={NARROW}
        count={of.rowsKept.value}
        chosen={of.chosen.value}
        follow={follow}
        onChoose={(row, by) => of.choose(row, by === 'key' ? 'edit' : 'step')}
        attributes={(row) => ({ 'data-severity': severityOf(of.row(row)) })}
      >
        {(index) => <Row of={of} row={of.row(index)} />}
      </VirtualList>
      <MarkStrip of={of} />
    </div>
  );
}

const severityOf = (row: TraceRow | undefined) => {
  const kinds = row?.faults.map(({ kind }) => traceSeverity(kind)) ?? [];
  return kinds.includes('error') ? 'error' : kinds[0];
};

type Cells = Partial<Record<(typeof COLUMNS)[number], ComponentChildren>>;

/** A row that a worker has not sent yet is not nameless for those who hear the page. */
const WAITING: Cells = { means: '…' };

/** A row has all its elements also while it waits: elements that come and go cost more than all else when a list is scrolled. */
function Row({ of, row }: { readonly of: TraceView<File>; readonly row: TraceRow | undefined }) {
  const words = useWords('trace');
  const cells = row ? cellsOf(row, of, words) : WAITING;
  return (
    <>
      {COLUMNS.map((column) => (
        <span key={column} class={column === 'hex' ? 'mono hex' : column}>
          {cells[column]}
        </span>
      ))}
    </>
  );
}

function cellsOf(row: TraceRow, of: TraceView<File>, words: ReturnType<typeof useWords<'trace'>>): Cells {
  const { index, exchange, gap, side = 'request', unit, after, hex, length, reply, known } = row;
  const bytes = fromHex(hex) ?? new Uint8Array(0);
  const isExchange = of.by.value === 'exchange';
  return {
    number: of.gone.value[of.by.value] + (isExchange ? exchange : index) + 1,
    time: timeText(row, timeKind.value, of.state.value),
    gap: gap !== undefined && words.gap(gap),
    side: known?.why === undefined && (
      <>
        <span aria-hidden="true">{reply ? '⇄' : side === 'request' ? '→' : '←'}</span>
        {!reply && <span class="unseen">{words.sides[side]}</span>}
      </>
    ),
    unit: words.isFrame(row) && unit,
    function: words.functionOf(row),
    means: words.means(row),
    after: after !== undefined && words.duration(after),
    mark: words.remarks(row).join(', '),
    hex: `${formatBytes(bytes)}${length > bytes.length ? ' …' : ''}`,
  };
}
