import { KnownValues, type Trace, type TraceCause, TraceStatistics } from '../../trace/index.ts';
import { filterKnown } from './describe.ts';
import type { ReaderClock } from './moment.ts';
import { knownColumns, type TabAnswer, type TabTask } from './tab-messages.ts';
import { MOST_TALLIES, sortedTallies } from './tallies.ts';
import { TimelineMaker } from './timeline.ts';
import type { TraceList } from './trace-list.ts';

/** Rows and exchanges that are looked at before other tasks have their turn. */
const ROWS = 50_000;
const EXCHANGES = 4000;
/** A trace that grows is counted anew while it has fewer exchanges than this. */
const FEW = 20_000;
/** Of a longer one these are left for later: their replies may still come. */
const UNSETTLED = 256;

/** What holds the trace, and its list. */
interface Held {
  readonly trace: Trace;
  readonly list: TraceList;
  readonly number: number;
  readonly causes: readonly TraceCause[];
  readonly clock: ReaderClock;
  /** Whether the trace may still grow. */
  readonly isLive: boolean;
}

interface Counted {
  readonly statistics: TraceStatistics;
  readonly values: KnownValues;
}

/** Counts for the tabs beside the list, a part at a time, one task after another. */
export class TabDesk {
  readonly #held: () => Held;
  readonly #answer: (answer: TabAnswer) => void;
  readonly #later: (act: () => void) => void;
  readonly #waiting: TabTask[] = [];
  #works = false;
  #trace: Trace | undefined;
  /** What has been counted of it, which is gone on with. */
  #counted: Partial<Counted> = {};

  constructor(held: () => Held, answer: (answer: TabAnswer) => void, later: (act: () => void) => void) {
    this.#held = held;
    this.#answer = answer;
    this.#later = later;
  }

  /** What has been counted does not hold any more. */
  recount(): void {
    this.#counted = {};
  }

  take(task: TabTask): void {
    // Only the last of a kind is wanted.
    const before = this.#waiting.findIndex(({ kind }) => kind === task.kind);
    if (before >= 0) this.#waiting.splice(before, 1);
    this.#waiting.push(task);
    if (this.#works) return;
    this.#works = true;
    this.#goOn();
  }

  #goOn(): void {
    const task = this.#waiting.shift();
    if (task === undefined) {
      this.#works = false;
      return;
    }
    const step = this.#steps(task);
    const go = () => {
      if (step()) this.#goOn();
      else this.#later(go);
    };
    go();
  }

  /** Does a part of a task each time it is called; true once it has been answered. */
  #steps(task: TabTask): () => boolean {
    switch (task.kind) {
      case 'timeline':
        return this.#timeline(task.columns);
      case 'statistics':
        return this.#counting(
          task,
          'statistics',
          (trace) => new TraceStatistics(trace),
          (statistics) => {
            const tallies = sortedTallies(statistics.by(task.by), task.sort);
            const { length: count } = tallies;
            return { kind: 'tallies', by: task.by, tallies: tallies.slice(0, MOST_TALLIES), count };
          },
        );
      case 'occurring': {
        const { causes, clock } = this.#held();
        return this.#counting(
          task,
          'statistics',
          (trace) => new TraceStatistics(trace),
          (statistics, trace) => ({ kind: 'occurring', known: filterKnown(trace, statistics, causes, clock) }),
        );
      }
      case 'values':
        return this.#counting(
          task,
          'values',
          (trace) => new KnownValues(trace),
          (values) => ({
            kind: 'values',
            known: knownColumns(values.list, this.#trace?.span?.first),
          }),
        );
    }
  }

  #counting<K extends keyof Counted>(
    task: TabTask,
    kind: K,
    make: (trace: Trace) => Counted[K],
    answer: (counted: Counted[K], trace: Trace) => TabAnswer,
  ): () => boolean {
    const { trace, isLive } = this.#held();
    const { exchangeCount } = trace;
    const end = isLive && exchangeCount >= FEW ? exchangeCount - UNSETTLED : exchangeCount;
    if (this.#trace !== trace) this.#counted = {};
    this.#trace = trace;
    const before = this.#counted[kind];
    const anew = before === undefined || (isLive && (end < FEW || before.taken > end));
    const counted: Counted[K] = anew ? make(trace) : before;
    this.#counted = { ...this.#counted, [kind]: counted };
    return () => {
      if (this.#held().trace !== trace) {
        this.#waiting.push(task);
        return true;
      }
      if (counted.take(trace.exchangeCount - end, EXCHANGES).taken < end) return false;
      this.#answer(answer(counted, trace));
      return true;
    };
  }

  /** The list as it stands once the filter has looked at everything; another list begins another timeline. */
  #timeline(columns: number): () => boolean {
    let made: { readonly list: TraceList; readonly count: number; readonly maker: TimelineMaker } | undefined;
    return () => {
      const { trace, list, number } = this.#held();
      if (!list.done) return false;
      if (made?.list !== list || made.count !== list.count)
        made = { list, count: list.count, maker: new TimelineMaker(trace, list, columns) };
      if (!made.maker.go(ROWS)) return false;
      this.#answer({ kind: 'timeline', list: number, timeline: made.maker.timeline });
      return true;
    };
  }
}
