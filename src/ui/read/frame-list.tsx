import { elementScroll, observeElementOffset, observeElementRect, Virtualizer } from '@tanstack/virtual-core';
import { Component, createRef } from 'preact';
import { decodeFrame } from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import { words as pageWords } from '../language.ts';
import { commit } from '../state.ts';
import { readWords as words } from './language.ts';
import { choose } from './pasted.ts';
import type { PastedItem, TextReading } from './read-text.ts';

/** Height of a line, in pixels; the style sheet has the same. */
const LINE = 32;
/** Bytes shown of a frame. */
const SHOWN = 24;

interface ListProps {
  readonly reading: TextReading;
  readonly chosen: number;
}

/** The frames of a text, one a line: only those in sight are drawn. */
export class FrameList extends Component<ListProps> {
  private readonly element = createRef<HTMLDivElement>();
  private readonly list = new Virtualizer<HTMLDivElement, HTMLElement>(this.options());
  private stop: (() => void) | undefined;

  private options() {
    return {
      count: this.props.reading.items.length,
      getScrollElement: () => this.element.current,
      estimateSize: () => LINE,
      overscan: 8,
      scrollToFn: elementScroll,
      observeElementRect,
      observeElementOffset,
      onChange: () => this.forceUpdate(),
    };
  }

  override componentDidMount() {
    this.stop = this.list._didMount();
    this.list._willUpdate();
  }

  override componentDidUpdate(before: ListProps) {
    this.list._willUpdate();
    if (before.reading !== this.props.reading) this.list.scrollToOffset(0);
  }

  override componentWillUnmount() {
    this.stop?.();
  }

  private readonly go = (event: KeyboardEvent) => {
    const { reading, chosen } = this.props;
    const last = reading.items.length - 1;
    const page = Math.floor((this.element.current?.clientHeight ?? LINE) / LINE);
    const to = {
      ArrowDown: chosen + 1,
      ArrowUp: chosen - 1,
      PageDown: chosen + page,
      PageUp: chosen - page,
      Home: 0,
      End: last,
    }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    const index = Math.max(0, Math.min(last, to));
    choose(index, 'edit');
    this.list.scrollToIndex(index);
  };

  render() {
    const { reading, chosen } = this.props;
    const { items, bytes } = reading;
    this.list.setOptions(this.options());
    return (
      <div
        class="frame-list"
        ref={this.element}
        role="listbox"
        aria-label={words.frames(items.filter(({ kind }) => kind === 'frame').length)}
        aria-activedescendant={`pasted-${chosen}`}
        tabIndex={0}
        onKeyDown={this.go}
        onClick={take}
        onBlur={commit}
      >
        <div style={{ height: `${this.list.getTotalSize()}px` }} role="presentation">
          {this.list.getVirtualItems().map(({ index, start }) => {
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
  if (line) choose(Number(line.dataset['index']), 'step');
}

function Line({ item, bytes, index }: { item: PastedItem; bytes: Uint8Array; index: number }) {
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
          <span>{pageWords.page.summary(decodeFrame(bytes, item), bytes.length, item.transport)}</span>
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
      <span class="mark">{severity && pageWords.page.severities[severity]}</span>
    </>
  );
}

/** Bytes in no frame are as wrong as a frame can be. */
const severityOf = (item: PastedItem) => (item.kind === 'frame' ? item.severity : 'error');
