import { type Capture, type PrintedClock, readCapture, type UnframedPiece } from '../../captures/index.ts';
import type { Profile } from '../../devices/index.ts';
import { causesOf, Trace, type TraceCause, type TraceSummary } from '../../trace/index.ts';
import { ExportDesk } from './export-desk.ts';
import { parseFilter } from './filter.ts';
import type { RowUnit, TraceAnswer, TraceTask } from './messages.ts';
import type { ReaderClock } from './moment.ts';
import { exchangeRowOf, rowOf, type TraceRow } from './row.ts';
import { TabDesk } from './tab-desk.ts';
import { clockOfTimes } from './trace-csv.ts';
import { TraceList } from './trace-list.ts';
import type { ReportWords } from './trace-report.ts';

/** The tasks that are done at once. */
type Task = Exclude<TraceTask, { readonly kind: 'open' }>;

/** Rows that the filter looks at before other tasks have their turn. */
const SLICE = 20_000;
/** Records that are traced between two percents at most. */
const STEP = 4096;
/** The part of the time that goes into reading a file that is not traced yet. */
const READING = 0.5;
const MOST_PROBLEMS = 200;
const NONE_GONE: Readonly<Record<RowUnit, number>> = Object.freeze({ frame: 0, exchange: 0 });
/** Causes are looked for again when a trace has grown by a tenth, and what is wrong in it too. */
const GROWN = 1.1;

/** Holds a trace, its list, and answers what a window asks of them. Knows no worker: what it says goes to `answer`. */
export class TraceDesk {
  /** What the reader's clock is ahead of UTC at a time. */
  zone: ReaderClock = () => 0;
  /** What a report says; without it, none is made. */
  report: ReportWords | undefined;
  /** The sentence of a row, in which `text:` looks. */
  says: ((row: TraceRow) => string) | undefined;
  readonly #answer: (answer: TraceAnswer) => void;
  readonly #later: (act: () => void) => void;
  #trace = new Trace();
  #causes: readonly TraceCause[] = [];
  /** How long the trace was when causes were looked for, and how many faults it had. */
  #causesAt = { size: 0, faults: 0 };
  /** What the source prints for its times. */
  #clock: PrintedClock | undefined;
  #gone: Readonly<Record<RowUnit, number>> = NONE_GONE;
  #filter = '';
  /** Of the list, by which the window knows it. */
  #number = 0;
  #profile: Profile | undefined;
  #list = this.#listOf('', 'frame');
  #goesOn = false;
  /** What was told of a list last. */
  #told: { readonly list: TraceList; readonly percent: number } | undefined;
  /** The record that was chosen, whose row in another list is told. */
  #chosen: number | undefined;

  /** Whether records have been added since the trace began. */
  #isLive = false;
  readonly #tabs: TabDesk;
  readonly #exports: ExportDesk;

  /** @param later does something after the tasks that wait */
  constructor(answer: (answer: TraceAnswer) => void, later: (act: () => void) => void) {
    this.#answer = answer;
    this.#later = later;
    const held = () => ({
      trace: this.#trace,
      list: this.#list,
      number: this.#number,
      causes: this.#causes,
      clock: this.#readerClock,
      isLive: this.#isLive,
    });
    this.#tabs = new TabDesk(held, answer, later);
    const toSave = () => ({
      trace: this.#trace,
      list: this.#list,
      filter: this.#filter,
      profile: this.#profile,
      clock: this.#clock,
      zone: this.zone,
      words: { sentence: this.says, report: this.report },
    });
    this.#exports = new ExportDesk(toSave, answer, later);
  }

  /** Reads the bytes of a file: its records take the place of all others. */
  open(bytes: Uint8Array): void {
    let told = -1;
    const tell = (done: number) => {
      const percent = Math.floor(100 * done);
      if (percent > told) this.#answer({ kind: 'progress', percent });
      told = Math.max(told, percent);
    };
    tell(0);
    this.#exports.stop();
    const capture = readCapture(bytes, undefined, (done) => tell(READING * done));
    this.#trace = traced(capture, (done) => tell(READING + (1 - READING) * done));
    this.#gone = NONE_GONE;
    this.#isLive = false;
    this.#clock = capture.clock ?? clockOfTimes(this.#trace.span?.last);
    const { format, pieces = [] } = capture;
    const shown = new Set(pieces.map(({ problem }) => problem));
    // A piece in no frame has a row.
    const problems = capture.problems.filter((problem) => !shown.has(problem));
    this.#lookForCauses();
    this.#answer({
      kind: 'opened',
      format,
      problems: problems.slice(0, MOST_PROBLEMS),
      problemCount: problems.length,
      clock: this.#clock,
    });
    this.#grown();
    this.#chosen = undefined;
    this.#begin(this.#filter, this.#list.by);
  }

  take(task: Task): void {
    switch (task.kind) {
      case 'append':
        this.#isLive = true;
        for (const record of task.records) this.#trace.add(record);
        if (task.most !== undefined && this.#trace.size > 2 * task.most) this.#keepLast(task.most);
        this.#list.again();
        this.#grown(this.#trace.size > GROWN * this.#causesAt.size);
        this.#goOn();
        break;
      case 'clear':
        this.#exports.stop();
        this.#trace = new Trace();
        this.#gone = NONE_GONE;
        this.#chosen = undefined;
        this.#lookForCauses();
        this.#grown();
        this.#begin(this.#filter, this.#list.by);
        break;
      case 'filter':
        this.#number = task.list;
        if (task.record !== undefined)
          this.#chosen = this.#trace.size > task.record && task.record >= 0 ? task.record : undefined;
        this.#begin(task.text, task.by);
        break;
      case 'device':
        this.#profile = task.profile;
        this.#begin(this.#filter, this.#list.by);
        break;
      case 'line':
        this.#trace.judgeSilences(task.line);
        this.#tabs.recount();
        this.#lookForCauses();
        this.#grown();
        this.#begin(this.#filter, this.#list.by);
        break;
      case 'rows': {
        const { from, to } = task;
        const rows = Array.from({ length: Math.max(0, to - from) }, (_, at) => this.#row(from + at) ?? []).flat();
        this.#answer({ kind: 'rows', list: this.#number, from, rows });
        break;
      }
      case 'frame':
        this.#frame(task.row);
        break;
      case 'fault':
        this.#answer({ kind: 'fault', list: this.#number, row: this.#list.fault(task.from, task.by) });
        break;
      case 'timeline':
      case 'statistics':
      case 'values':
      case 'occurring':
        this.#tabs.take(task);
        break;
      case 'export':
      case 'no-export':
        this.#exports.take(task);
        break;
    }
  }

  #row(row: number): TraceRow | undefined {
    const index = this.#list.at(row);
    if (index === undefined) return undefined;
    return this.#list.by === 'frame'
      ? rowOf(this.#trace, index, this.#profile)
      : exchangeRowOf(this.#trace, index, this.#profile);
  }

  #frame(row: number): void {
    const found = this.#row(row);
    if (found === undefined) return;
    const { index, side, transport } = found;
    this.#chosen = index;
    const [{ request, replies } = { request: undefined, replies: [] }] = this.#trace.exchanges(
      found.exchange,
      found.exchange + 1,
    );
    const [reply] = replies;
    const bytes = (record: number | undefined) =>
      record === undefined || record === index ? undefined : this.#trace.bytes(record).slice();
    this.#answer({
      kind: 'frame',
      list: this.#number,
      row,
      frame: {
        index,
        side,
        transport,
        bytes: this.#trace.bytes(index).slice(),
        request: bytes(request),
        reply: side === 'request' ? bytes(reply) : undefined,
        about: { row: found, silence: silenceOf(this.#trace, found, this.#profile) },
      },
    });
  }

  #lookForCauses(): void {
    this.#causes = causesOf(this.#trace);
    this.#causesAt = { size: this.#trace.size, faults: faultsIn(this.#trace.summary()) };
  }

  /** Tells what the trace comes to; `much` says that it is much longer than when causes were looked for. */
  #grown(much = false): void {
    const summary = this.#trace.summary();
    if (much && faultsIn(summary) > GROWN * this.#causesAt.faults) this.#lookForCauses();
    const causes = this.#causes.map(({ exchanges: _exchanges, ...said }) => said);
    this.#answer({ kind: 'grown', summary, pieces: this.#trace.pieces, causes, gone: this.#gone });
  }

  /** Keeps at least the last records of a trace that grows, from a request on; the others are gone. */
  #keepLast(most: number): void {
    const trace = this.#trace;
    let first = trace.size - most;
    while (first > 0 && trace.spoken(first).side !== 'request') first--;
    const rest = trace.behind(first);
    const gone = trace.exchangeCount - rest.exchangeCount;
    this.#gone = { frame: this.#gone.frame + first, exchange: this.#gone.exchange + gone };
    if (this.#chosen !== undefined) this.#chosen = this.#chosen < first ? undefined : this.#chosen - first;
    this.#trace = rest;
    this.#lookForCauses();
    this.#list = this.#listOf(this.#filter, this.#list.by);
  }

  get #readerClock(): ReaderClock {
    const clock = this.#clock;
    return clock === undefined ? this.zone : () => clock.shift;
  }

  #listOf(text: string, by: TraceList['by']): TraceList {
    const filter = parseFilter(text);
    if (filter.kind !== 'filter') throw new TypeError(`Not a filter: ${text}`);
    return new TraceList(this.#trace, filter, by, {
      profile: this.#profile,
      causes: this.#causes,
      says: this.says,
      clock: this.#readerClock,
    });
  }

  /** Begins a list anew. */
  #begin(text: string, by: TraceList['by']): void {
    this.#filter = text;
    this.#list = this.#listOf(text, by);
    this.#goOn();
  }

  /** Goes on with the list, and lets other tasks have their turn now and then. */
  readonly #goOn = (): void => {
    if (this.#goesOn) return;
    this.#list.go(SLICE);
    const { done, count, looked } = this.#list;
    const percent = Math.floor(100 * looked);
    const chosen = done && this.#chosen !== undefined ? this.#list.rowOf(this.#chosen) : undefined;
    // Who shows the list draws it again each time: it is told each percent, and not each slice.
    const isNews = done || this.#told?.list !== this.#list || percent > this.#told.percent;
    if (isNews) {
      this.#told = { list: this.#list, percent };
      this.#answer({
        kind: 'list',
        list: this.#number,
        from: this.#list.takeChanged(),
        count,
        pieces: this.#list.pieces,
        done,
        percent,
        marks: done ? this.#list.marks : [],
        chosen,
      });
    }
    if (done) return;
    this.#goesOn = true;
    this.#later(() => {
      this.#goesOn = false;
      this.#goOn();
    });
  };
}

/** Records that are looked through for the next one between the same ends. */
const MOST_BETWEEN = 1000;

/** What came in place of the reply to a row's request; `undefined` if it has one, or none is due. */
function silenceOf(trace: Trace, { index, faults, known }: TraceRow, profile: Profile | undefined) {
  if (faults.every(({ kind }) => kind !== 'no-reply')) return undefined;
  const { connection, time } = trace.spoken(index);
  const end = Math.min(trace.size, index + MOST_BETWEEN);
  let next = index + 1;
  while (next < end && trace.isFrame(next) && trace.spoken(next).connection !== connection) next++;
  const timeout = known?.outcome === undefined ? trace.timeout : undefined;
  if (next >= end) return { timeout };
  const { time: then } = trace.spoken(next);
  const after = time === undefined || then === undefined ? undefined : then - time;
  return { timeout, next: rowOf(trace, next, profile), after };
}

const faultsIn = ({ faults }: TraceSummary): number => Object.values(faults).reduce((sum, count) => sum + count, 0);

/** The trace of a capture, with its pieces in no frame where they stand; `tell` hears which part is done. */
function traced({ records, pieces = [] }: Capture, tell: (done: number) => void): Trace {
  const trace = new Trace();
  let [index, piece] = [0, 0];
  const addPieces = () => {
    for (; piece < pieces.length && (pieces[piece]?.before ?? 0) <= index; piece++)
      trace.add((pieces[piece] as UnframedPiece).record);
  };
  for (const record of records) {
    if (index % STEP === 0) tell(index / records.length);
    if (piece < pieces.length) addPieces();
    trace.add(record);
    index++;
  }
  addPieces();
  return trace;
}
