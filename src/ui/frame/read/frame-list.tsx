import type { RefObject } from 'preact';
import { decodeFrame } from '../../../modbus/index.ts';
import { formatBytes } from '../../../notation/index.ts';
import type { Vocabulary } from '../../../words/index.ts';
import type { PastedItem, TextReading } from '../../../workbench/index.ts';
import { VirtualLines } from '../../kit/virtual-lines.ts';
import { pasted } from '../../parts/pasted.ts';
import { commit } from '../../parts/store.ts';
import { useWords, Words } from '../../parts/words.ts';

/** Bytes shown of a frame. */
const SHOWN = 24;

interface ListProps {
  readonly reading: TextReading;
  readonly chosen: number;
}

/** The frames of a text, one a line: only those in sight are drawn. */
export class FrameList extends VirtualLines<ListProps> {
  static override contextType = Words;
  protected readonly line = 32;

  protected count() {
    return this.props.reading.items.length;
  }

  override componentDidUpdate(before: ListProps) {
    super.componentDidUpdate(before);
    if (before.reading !== this.props.reading) this.lines().scrollToOffset(0);
  }

  private readonly go = (event: KeyboardEvent) => {
    const index = this.placeFor(event, this.props.chosen);
    if (index === undefined) return;
    event.preventDefault();
    pasted.choose(index, 'edit');
    this.lines().scrollToIndex(index);
  };

  render() {
    const { reading, chosen } = this.props;
    const { items, bytes } = reading;
    const vocabulary: Vocabulary = this.context;
    const frames = items.filter(({ kind }) => kind === 'frame').length;
    const list = this.lines();
    return (
      <div
        class="virtual-lines frame-list"
        ref={this.element as RefObject<HTMLDivElement>}
        role="listbox"
        aria-label={vocabulary.of('read').frames(frames)}
        aria-activedescendant={`pasted-${chosen}`}
        tabIndex={0}
        onKeyDown={this.go}
        onClick={take}
        onBlur={commit}
      >
        <div style={{ height: `${list.getTotalSize()}px` }} role="presentation">
          {list.getVirtualItems().map(({ index, start }) => {
            const item = items[index];
            return (
              item && (
                <div
                  key={index}
                  id={`pasted-${index}`}
                  role="option"
                  tabIndex={-1}
                  data-index={index}
                  aria-selected={index === chosen}
                  aria-posinset={index + 1}
                  aria-setsize={items.length}
                  data-severity={severityOf(item)}
                  style={{ transform: `translateY(${start}px)` }}
                >
                  <Line item={item} bytes={bytes.subarray(item.from, item.to)} index={index} />
                </div>
              )
            );
          })}
        </div>
      </div>
    );
  }
}

/** The line that was clicked. */
function take({ target }: MouseEvent): void {
  const line = target instanceof Element ? target.closest<HTMLElement>('[data-index]') : null;
  if (line) pasted.choose(Number(line.dataset['index']), 'step');
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
