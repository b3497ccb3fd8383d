import { decodeFrame } from '../../../modbus/index.ts';
import { formatBytes } from '../../../notation/index.ts';
import { faultSeverity, type LogFault, type PastedItem, type TextReading } from '../../../workbench/index.ts';
import { VirtualList } from '../../kit/virtual-list.tsx';
import { useFaultKeys } from '../../parts/fault-keys.ts';
import { pasted } from '../../parts/pasted.ts';
import { commit } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import './frame-list.css';

/** Bytes shown of a frame. */
const SHOWN = 24;

interface ListProps {
  readonly reading: TextReading;
  readonly chosen: number;
}

/** The frames of a text, one a line: only those in sight are drawn. */
export function FrameList({ reading, chosen }: ListProps) {
  const words = useWords('read');
  const { items, bytes, faults } = reading;
  const severityAt = (index: number) => {
    const fault = faults.byIndex.get(index);
    return fault ? faultSeverity(fault) : noteOf(items[index]);
  };
  useFaultKeys({
    count: items.length,
    chosen,
    isFaulty: (index) => faults.byIndex.has(index),
    choose: (index) => pasted.choose(index, 'step'),
  });
  return (
    <VirtualList
      id="pasted"
      class="frame-list"
      label={words.frames(items.filter(({ kind }) => kind === 'frame').length)}
      count={items.length}
      chosen={chosen}
      of={reading}
      onChoose={(index, by) => pasted.choose(index, by === 'key' ? 'edit' : 'step')}
      onLeave={commit}
      attributes={(index) => ({ 'data-severity': severityAt(index) })}
    >
      {(index) => {
        const item = items[index];
        const line = { index, fault: faults.byIndex.get(index), bytes: bytes.subarray(item?.from, item?.to) };
        return item && <Line item={item} {...line} />;
      }}
    </VirtualList>
  );
}

interface LineProps {
  readonly item: PastedItem;
  readonly fault: LogFault | undefined;
  readonly bytes: Uint8Array;
  readonly index: number;
}

function Line({ item, fault, bytes, index }: LineProps) {
  const words = useWords('read');
  const { page } = useWords('page');
  const note = noteOf(item);
  return (
    <>
      <span class="number">{index + 1}</span>
      <span class="mono time">{item.time}</span>
      {item.kind === 'frame' ? (
        <>
          <span>
            {words.directions[item.direction]}{' '}
            {item.answers !== undefined && <small>{words.answers(item.answers + 1)}</small>}
          </span>
          <span>{page.summary(decodeFrame(bytes, item), bytes.length, item.transport)}</span>
        </>
      ) : (
        <>
          <span />
          <span />
        </>
      )}
      <span class="mono hex">
        {formatBytes(bytes.subarray(0, SHOWN))}
        {bytes.length > SHOWN && ' …'}
      </span>
      <span class="mark">{fault ? words.fault(fault) : note && page.severities[note]}</span>
    </>
  );
}

/** What is worth knowing of a frame without a fault. */
const noteOf = (item: PastedItem | undefined) => (item?.kind === 'frame' ? item.severity : undefined);
