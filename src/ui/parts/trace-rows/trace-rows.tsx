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
        {(index) => {
          const row = of.row(index);
          // A row that a worker has not sent yet is not nameless for those who hear the page.
          return row ? <Row of={of} row={row} /> : '…';
        }}
      </VirtualList>
      <MarkStrip of={of} />
    </div>
  );
}

const severityOf = (row: TraceRow | undefined) => {
  const kinds = row?.faults.map(({ kind }) => traceSeverity(kind)) ?? [];
  return kinds.includes('error') ? 'error' : kinds[0];
};

function Row({ of, row }: { readonly of: TraceView<File>; readonly row: TraceRow }) {
  const words = useWords('trace');
  const { index, exchange, gap, side = 'request', unit, after, hex, length, reply, known } = row;
  const bytes = fromHex(hex) ?? new Uint8Array(0);
  const isExchange = of.by.value === 'exchange';
  const gone = of.gone.value[of.by.value];
  return (
    <>
      <span class="number">{gone + (isExchange ? exchange : index) + 1}</span>
      <span class="time">{timeText(row, timeKind.value, of.state.value)}</span>
      <span class="gap">{gap !== undefined && words.gap(gap)}</span>
      <span class="side">
        {known?.why === undefined && (
          <>
            <span aria-hidden="true">{reply ? '⇄' : side === 'request' ? '→' : '←'}</span>
            {!reply && <span class="unseen">{words.sides[side]}</span>}
          </>
        )}
      </span>
      <span class="unit">{words.isFrame(row) && unit}</span>
      <span class="function">{words.functionOf(row)}</span>
      <span class="means">{words.means(row)}</span>
      <span class="after">{after !== undefined && words.duration(after)}</span>
      <span class="mark">{words.remarks(row).join(', ')}</span>
      <span class="mono hex">
        {formatBytes(bytes)}
        {length > bytes.length && ' …'}
      </span>
    </>
  );
}
