import { fromHex } from '../../../modbus/index.ts';
import { formatBytes } from '../../../notation/index.ts';
import type { TraceView } from '../../../store/index.ts';
import { type TraceRow, traceSeverity } from '../../../workbench/index.ts';
import { VirtualList } from '../../kit/virtual-list.tsx';
import { useCommand } from '../commands.ts';
import { useWords } from '../words.ts';
import './trace-rows.css';

/** In a narrower list, in pixels, the bytes stand under what a frame means. */
const NARROW = 960;

/** The frames of a trace, one a row: only those in sight are drawn. */
export function TraceRows({ of }: { readonly of: TraceView<File> }) {
  const words = useWords('trace');
  of.revision.value;
  useCommand('next-fault', of.nextFault);
  useCommand('previous-fault', of.previousFault);
  const severityOf = (row: TraceRow | undefined) => {
    const kinds = row?.faults.map(({ kind }) => traceSeverity(kind)) ?? [];
    return kinds.includes('error') ? 'error' : kinds[0];
  };
  return (
    <VirtualList
      id="trace"
      class="trace-rows"
      label={words.rows(of.rowsKept.value, of.by.value)}
      breaksBelow={NARROW}
      count={of.rowsKept.value}
      chosen={of.chosen.value}
      onChoose={(row, by) => of.choose(row, by === 'key' ? 'edit' : 'step')}
      attributes={(row) => ({ 'data-severity': severityOf(of.row(row)) })}
    >
      {(index) => {
        const row = of.row(index);
        return row && <Row {...row} />;
      }}
    </VirtualList>
  );
}

function Row(row: TraceRow) {
  const words = useWords('trace');
  const { index, side, unit, functionCode, after, faults, hex, length } = row;
  const bytes = fromHex(hex) ?? new Uint8Array(0);
  return (
    <>
      <span class="number">{index + 1}</span>
      <span class="side">{side === 'request' ? '→' : '←'}</span>
      <span class="unit">{unit}</span>
      <span class="function">{words.functionName(functionCode)}</span>
      <span class="means">{words.means(row)}</span>
      <span class="after">{after !== undefined && words.duration(after)}</span>
      <span class="mark">{faults.map(({ kind }) => words.fault(kind)).join(', ')}</span>
      <span class="mono hex">
        {formatBytes(bytes)}
        {length > bytes.length && ' …'}
      </span>
    </>
  );
}
