import type { VNode } from 'preact';
import { useMemo, useState } from 'preact/hooks';
import type { LogLine } from '../../bus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import type { WordsOf } from '../../words/index.ts';
import { isLineTrouble, type LineWords, lineBytes, lineMeaning } from '../../workbench/index.ts';
import { VirtualList } from '../kit/virtual-list.tsx';
import { useFaultKeys } from '../parts/fault-keys.ts';

/** What is said in the log. */
export type LogWords = WordsOf<'bus'>['log'] & LineWords;

/** Bytes shown of a frame. */
const SHOWN = 16;
/** In a narrower log, in pixels, a frame stands under its meaning. */
const NARROW = 960;

interface ListProps {
  readonly lines: readonly LogLine[];
  readonly words: LogWords;
  /** Whether the last line is kept in sight. */
  readonly follow: boolean;
  readonly onOpen: (line: LogLine) => void;
}

/** The lines of the log: only those in sight are drawn. */
export function LogList({ lines, words, follow, onOpen }: ListProps) {
  const [chosen, choose] = useState(0);
  // A line never changes, so that it is drawn once.
  const drawn = useMemo(() => new WeakMap<LogLine, VNode>(), [words]);
  useFaultKeys({
    count: lines.length,
    chosen,
    isFaulty: (index) => attributesOf(lines[index])['data-severity'] !== undefined,
    choose,
  });
  const open = (index: number) => {
    const line = lines[index];
    if (line) onOpen(line);
  };
  return (
    <VirtualList
      id="log"
      class="log-list"
      breaksBelow={NARROW}
      label={words.lines(lines.length)}
      count={lines.length}
      chosen={chosen}
      follow={follow}
      onChoose={(index, by) => (by === 'key' ? choose(index) : open(index))}
      onEnter={open}
      attributes={(index) => attributesOf(lines[index])}
    >
      {(index) => {
        const line = lines[index];
        if (line === undefined) return undefined;
        const node = drawn.get(line) ?? <Line line={line} words={words} />;
        drawn.set(line, node);
        return node;
      }}
    </VirtualList>
  );
}

const attributesOf = (line: LogLine | undefined) => ({
  'data-severity': line?.verdict === 'doubtful' ? 'warning' : line && isLineTrouble(line) ? 'error' : undefined,
  'data-direction': line?.direction,
  'data-verdict': line?.verdict,
});

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
