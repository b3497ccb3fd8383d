import type { RefObject } from 'preact';
import type { LogLine } from '../../bus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import type { WordsOf } from '../../words/index.ts';
import { isLineTrouble, type LineWords, lineBytes, lineMeaning } from '../../workbench/index.ts';
import { VirtualLines } from '../kit/virtual-lines.ts';

/** What is said in the log. */
export type LogWords = WordsOf<'bus'>['log'] & LineWords;

/** Bytes shown of a frame. */
const SHOWN = 16;

interface ListProps {
  readonly lines: readonly LogLine[];
  readonly words: LogWords;
  /** Whether the last line is kept in sight. */
  readonly follow: boolean;
  readonly onOpen: (line: LogLine) => void;
}

/** The lines of the log: only those in sight are drawn. */
export class LogList extends VirtualLines<ListProps, { readonly chosen: number }> {
  override state = { chosen: 0 };
  protected readonly line = 32;

  protected count() {
    return this.props.lines.length;
  }

  override componentDidMount() {
    super.componentDidMount();
    this.keepUp();
  }

  override componentDidUpdate(before: ListProps) {
    super.componentDidUpdate(before);
    if (before.lines !== this.props.lines) this.keepUp();
  }

  private keepUp() {
    if (this.props.follow && this.props.lines.length > 0) this.lines().scrollToIndex(this.props.lines.length - 1);
  }

  private readonly go = (event: KeyboardEvent) => {
    const { lines, onOpen } = this.props;
    const chosen = Math.min(this.state.chosen, lines.length - 1);
    const line = lines[chosen];
    if (event.key === 'Enter' && line) onOpen(line);
    const index = this.placeFor(event, chosen);
    if (index === undefined) return;
    event.preventDefault();
    this.setState({ chosen: index });
    this.lines().scrollToIndex(index);
  };

  private readonly take = ({ target }: MouseEvent) => {
    const element = target instanceof Element ? target.closest<HTMLElement>('[data-index]') : null;
    const line = this.props.lines[Number(element?.dataset['index'])];
    if (line) this.props.onOpen(line);
  };

  render() {
    const { lines, words } = this.props;
    const list = this.lines();
    const drawn = list.getVirtualItems();
    const chosen = Math.min(this.state.chosen, lines.length - 1);
    return (
      <div
        class="virtual-lines log-list"
        ref={this.element as RefObject<HTMLDivElement>}
        role="listbox"
        aria-label={words.lines(lines.length)}
        aria-activedescendant={drawn.some(({ index }) => index === chosen) ? `log-${chosen}` : undefined}
        tabIndex={0}
        onKeyDown={this.go}
        onClick={this.take}
      >
        <div style={{ height: `${list.getTotalSize()}px` }} role="presentation">
          {drawn.map(({ index, start }) => {
            const line = lines[index];
            return (
              line && (
                <div
                  key={line.number}
                  id={`log-${index}`}
                  role="option"
                  tabIndex={-1}
                  data-index={index}
                  aria-selected={index === chosen}
                  aria-posinset={index + 1}
                  aria-setsize={lines.length}
                  data-severity={line.verdict === 'doubtful' ? 'warning' : isLineTrouble(line) ? 'error' : undefined}
                  data-direction={line.direction}
                  style={{ transform: `translateY(${start}px)` }}
                >
                  <Line line={line} words={words} />
                </div>
              )
            );
          })}
        </div>
      </div>
    );
  }
}

function Line({ line, words }: { readonly line: LogLine; readonly words: LogWords }) {
  const bytes = lineBytes(line);
  return (
    <>
      <span class="mono time">{timeOf(line.time)}</span>
      <span class="direction">
        <span aria-hidden="true">{line.direction === 'sent' ? '→' : '←'}</span> {words.kinds[line.kind]}
      </span>
      <span class="meaning">{lineMeaning(line, words)}</span>
      <span class="mono hex">
        {formatBytes(bytes.subarray(0, SHOWN))}
        {bytes.length > SHOWN && ' …'}
      </span>
      <span class="took">{line.duration !== undefined && words.milliseconds(line.duration)}</span>
      <span class="mark">{line.verdict && words.verdicts[line.verdict]}</span>
    </>
  );
}

const timeFormat = new Intl.DateTimeFormat(undefined, {
  hour: '2-digit',
  minute: '2-digit',
  second: '2-digit',
  fractionalSecondDigits: 3,
  hour12: false,
});
const timeOf = (time: number) => timeFormat.format(time);
