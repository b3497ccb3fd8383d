import { decodeFrame } from '../../../modbus/index.ts';
import { formatBytes } from '../../../notation/index.ts';
import type { PastedItem, TextReading } from '../../../workbench/index.ts';
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
  const { items, bytes } = reading;
  const severityAt = (index: number) => items[index] && severityOf(items[index]);
  useFaultKeys({
    count: items.length,
    chosen,
    isFaulty: (index) => ['error', 'warning'].includes(severityAt(index) ?? ''),
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
        return item && <Line item={item} bytes={bytes.subarray(item.from, item.to)} index={index} />;
      }}
    </VirtualList>
  );
}

function Line({ item, bytes, index }: { item: PastedItem; bytes: Uint8Array; index: number }) {
  const words = useWords('read');
  const { page } = useWords('page');
  const severity = severityOf(item);
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
          <span>{words.noFrameHere}</span>
        </>
      )}
      <span class="mono hex">
        {formatBytes(bytes.subarray(0, SHOWN))}
        {bytes.length > SHOWN && ' …'}
      </span>
      <span class="mark">{severity && page.severities[severity]}</span>
    </>
  );
}

/** Bytes in no frame are as wrong as a frame can be. */
const severityOf = (item: PastedItem) => (item.kind === 'frame' ? item.severity : 'error');
