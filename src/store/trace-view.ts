import { batch, computed, type ReadonlySignal, type Signal, signal } from '@preact/signals-core';
import type { WorkerEnd } from '../bus/index.ts';
import type { CaptureProblem, PrintedClock } from '../captures/index.ts';
import type { Profile } from '../devices/index.ts';
import type { TraceInput, TraceOptions, TraceSummary } from '../trace/index.ts';
import {
  type FilePart,
  type Filter,
  type How,
  type OwnLog,
  parseFilter,
  type RowAbout,
  type RowUnit,
  type SaidCause,
  type TraceAnswer,
  type TraceFailure,
  type TraceFrame,
  type TraceMark,
  type TraceRow,
  type TraceTask,
} from '../workbench/index.ts';
import { RowWindows } from './row-windows.ts';
import { TraceExport } from './trace-export.ts';
import { TraceKnown } from './trace-known.ts';
import { TraceTabs } from './trace-tabs.ts';

/** What holds a trace, in a worker. */
export interface TraceWorker<F> {
  post(task: TraceTask<F>): void;
  end(): void;
}

/** How the window lets a trace work. */
export interface TraceParts<F> {
  /** Starts a worker. Its answers come to `take`; `ended` is told why it does nothing any more. */
  readonly start: (
    take: (answer: TraceAnswer<F | FilePart>) => void,
    ended: (why: WorkerEnd) => void,
  ) => TraceWorker<F>;
  /** Makes a frame the current one, with the other of its exchange. */
  readonly show: (frame: TraceFrame, how: How) => void;
}

/** A file as a browser hands it over. */
export interface NamedFile {
  readonly name: string;
}

/** What is there; `name` is that of the file, and `undefined` for any other source. */
export type TraceState =
  | { readonly kind: 'empty' }
  | { readonly kind: 'opening'; readonly name: string | undefined; readonly percent: number }
  | {
      readonly kind: 'open';
      readonly name: string | undefined;
      readonly format: string;
      /** What the source prints for its times. */
      readonly clock?: PrintedClock | undefined;
    }
  | { readonly kind: 'failed'; readonly name: string | undefined; readonly code: TraceFailure };

/** What is wrong with a file: the first problems, and how many there are. */
interface Problems {
  readonly first: readonly CaptureProblem[];
  readonly count: number;
}

const NONE_GONE: Readonly<Record<RowUnit, number>> = Object.freeze({ frame: 0, exchange: 0 });
const NO_PROBLEMS: Problems = { first: [], count: 0 };

/** A trace of the page, which a worker holds: its list as it is filtered, and the frame that is chosen. */
export class TraceView<F extends NamedFile = NamedFile> {
  readonly state: Signal<TraceState> = signal({ kind: 'empty' });
  /** The file that is open, or being opened. */
  readonly file: Signal<F | undefined> = signal(undefined);
  /** Raised when rows have come, or are others: whoever draws rows reads it. */
  readonly revision = signal(0);
  readonly summary: Signal<TraceSummary | undefined> = signal(undefined);
  /** How many records are pieces in no frame, and how many of the rows. */
  readonly pieces = signal(0);
  readonly piecesKept = signal(0);
  readonly causes: Signal<readonly SaidCause[]> = signal([]);
  /** How many frames and exchanges there were before the first, which are not kept any more. */
  readonly gone: Signal<Readonly<Record<RowUnit, number>>> = signal(NONE_GONE);
  readonly problems: Signal<Problems> = signal(NO_PROBLEMS);
  /** The text of the filter, and what a row of the list stands for. */
  readonly filter: Signal<string> = signal('');
  readonly by: Signal<RowUnit> = signal('frame');
  /** By the speed of which line silences are judged. */
  readonly line: Signal<TraceOptions['line']> = signal(undefined);
  /** The filter of the list as it is: the text, as long as that has no mistakes. */
  readonly applied: Signal<string> = signal('');
  /** Whether the filter became what it is by a step, or is being typed. */
  filterHow: How = 'edit';
  /** What the text of the filter says. While it has mistakes, the list stays as it was. */
  readonly read: ReadonlySignal<Filter> = computed(() => parseFilter(this.filter.value));
  readonly rowsKept = signal(0);
  /** Whether the filter has not looked at all records yet, and at which part it has, in percent. */
  readonly filtering = signal(false);
  readonly filtered = signal(0);
  /** The log of the page itself that was opened. */
  readonly own: Signal<OwnLog | undefined> = signal(undefined);
  readonly marks: Signal<readonly TraceMark[]> = signal([]);
  /** The row that is chosen; −1 if none is, or if the filter leaves it out. */
  readonly chosen = signal(-1);
  /** The record that was chosen last, counted from 0; it may be one that the filter leaves out. */
  readonly record: Signal<number | undefined> = signal(undefined);
  /** What is to be said of the row that is chosen, beside what its bytes say. */
  readonly about: Signal<RowAbout | undefined> = signal(undefined);
  /** The record that an address names and the list does not have. */
  readonly missing: Signal<number | undefined> = signal(undefined);
  /** The timeline, the statistics and the values that are known. */
  readonly tabs = new TraceTabs((task) => this.#post(task));
  /** What the filter can be completed with. */
  readonly occurring = new TraceKnown((task) => this.#post(task));
  /** Files that are made of it. */
  readonly exports = new TraceExport<F>((task) => this.#post(task));
  readonly #parts: TraceParts<F>;
  #worker: TraceWorker<F> | undefined;
  #profile: Profile | undefined;
  /** The number of the list, which is another one with each filter. */
  #list = 0;
  /** The number of the list that was last told in full. */
  #told = -1;
  readonly #rows = new RowWindows((from, to) => this.#post({ kind: 'rows', from, to }));
  /** The row whose frame was asked for, and how it is to be shown. */
  #wanted: { readonly row: number; readonly how: How } | undefined;
  /** The ways to the next fault that wait: each begins where the one before it ends. */
  readonly #steps: (1 | -1)[] = [];
  /** Whether one of them has been asked for. */
  #asks = false;
  /** The record whose frame is shown when the list has been made. */
  #sought: number | undefined;

  constructor(parts: TraceParts<F>) {
    this.#parts = parts;
  }

  /** Opens a file; its records take the place of all others. */
  readonly open = (file: F): void => this.#open(file.name, { kind: 'open', source: { kind: 'file', file } });

  readonly openText = (text: string): void => this.#open(undefined, { kind: 'open', source: { kind: 'text', text } });

  /** Opens a log that the page has itself. */
  readonly openOwn = (log: OwnLog): void => {
    this.#open(undefined, { kind: 'open', source: { kind: 'own', log } });
    this.own.value = log;
  };

  /** Adds records at the end, as they are heard; at least the last `most` of all are kept. */
  append(records: readonly TraceInput[], most?: number): void {
    if (this.state.peek().kind !== 'open') this.state.value = { kind: 'open', name: undefined, format: '' };
    this.#post({ kind: 'append', records, most });
  }

  /** Forgets all records; the filter stays. */
  clear(): void {
    if (this.#worker) this.#post({ kind: 'clear' });
    this.#forget({ kind: 'empty' }, this.filter.peek());
  }

  /** Gives up what is being opened, and forgets what was there. */
  readonly cancel = (): void => {
    this.#end();
    this.#forget({ kind: 'empty' });
  };

  /** Filters the list; a text with mistakes changes nothing but itself. */
  readonly setFilter = (text: string, how: How = 'step'): void => {
    this.filterHow = how;
    this.filter.value = text;
    if (this.#readsFilter()) this.#filter();
  };

  /** Shows a list, and the frame that is chosen in it. */
  restore(filter: string, by: RowUnit, record: number | undefined): void {
    batch(() => {
      this.filterHow = 'edit';
      this.filter.value = filter;
      this.by.value = by;
      this.record.value = record;
      this.missing.value = undefined;
    });
    this.#readsFilter();
    this.#sought = record;
    this.#filter({ record: record ?? -1 });
  }

  /** Makes each row a frame, or an exchange. */
  readonly setUnit = (by: RowUnit): void => {
    this.by.value = by;
    this.#filter();
  };

  /** Judges silences by the speed of a line, or no more. */
  readonly setLine = (line: TraceOptions['line']): void => {
    this.line.value = line;
    this.#post({ kind: 'line', line });
    this.#filter();
  };

  /** The names that rows have are those of this device. */
  setDevice(profile: Profile | undefined): void {
    if (profile === this.#profile) return;
    this.#profile = profile;
    if (this.#worker) this.#post({ kind: 'device', profile });
  }

  /** A row that has come; one that has not is asked for, with those around it. */
  row(row: number): TraceRow | undefined {
    return this.#rows.at(row, this.rowsKept.peek());
  }

  /** Chooses a row, whose frame is shown: as a step, or in place while somebody goes through the list. */
  readonly choose = (row: number, how: How = 'step'): void => {
    if (row < 0 || row >= this.rowsKept.peek()) return;
    this.chosen.value = row;
    this.about.value = undefined;
    this.#wanted = { row, how };
    this.missing.value = undefined;
    this.#post({ kind: 'frame', row });
  };

  readonly nextFault = (): void => this.#toFault(1);
  readonly previousFault = (): void => this.#toFault(-1);

  #toFault(by: 1 | -1): void {
    this.#steps.push(by);
    this.#askForFault();
  }

  #askForFault(): void {
    // Where the chosen frame is in another list is told with that list.
    if (this.#asks || this.filtering.peek()) return;
    const by = this.#steps.shift();
    this.#asks = by !== undefined;
    if (by !== undefined) this.#post({ kind: 'fault', from: this.chosen.peek(), by });
  }

  #open(name: string | undefined, task: TraceTask<F>): void {
    // What is being read now is not waited for.
    if (this.state.peek().kind === 'opening') this.#end();
    this.own.value = undefined;
    this.#forget({ kind: 'opening', name, percent: 0 });
    if (task.kind === 'open' && task.source.kind === 'file') this.file.value = task.source.file;
    this.#post(task);
  }

  #forget(state: TraceState, filter = ''): void {
    batch(() => {
      this.state.value = state;
      this.file.value = undefined;
      this.summary.value = undefined;
      this.pieces.value = 0;
      this.piecesKept.value = 0;
      this.causes.value = [];
      this.problems.value = NO_PROBLEMS;
      this.filter.value = filter;
      if (filter === '') this.applied.value = filter;
      this.gone.value = NONE_GONE;
      this.#sought = undefined;
      this.record.value = undefined;
      this.about.value = undefined;
      this.line.value = undefined;
      this.missing.value = undefined;
      this.#anew();
      this.rowsKept.value = 0;
      this.marks.value = [];
      this.chosen.value = -1;
      this.tabs.forget();
      this.exports.forget();
      this.occurring.forget();
    });
    if (this.#worker) this.#filter();
  }

  /** Another list begins: nothing that was said of the one before holds. */
  #anew(): void {
    this.#list++;
    this.#rows.clear();
    this.#wanted = undefined;
    this.#steps.length = 0;
    this.#asks = false;
    this.revision.value++;
  }

  #filter(chosen: { readonly record?: number } = {}): void {
    this.#anew();
    this.filtering.value = true;
    this.filtered.value = 0;
    this.#post({ ...this.#listTask(), ...chosen });
  }

  #readsFilter(): boolean {
    const isFilter = this.read.peek().kind === 'filter';
    if (isFilter) this.applied.value = this.filter.peek().trim();
    return isFilter;
  }

  readonly #listTask = () =>
    ({ kind: 'filter', text: this.applied.peek(), by: this.by.peek(), list: this.#list }) as const;

  #post(task: TraceTask<F>): void {
    if (this.#worker === undefined) {
      const worker = this.#parts.start(this.#take, (code) => {
        if (this.#worker !== worker) return;
        this.#worker = undefined;
        const state = this.state.peek();
        this.#forget({ kind: 'failed', name: 'name' in state ? state.name : undefined, code });
      });
      this.#worker = worker;
      if (this.#profile) worker.post({ kind: 'device', profile: this.#profile });
      if (task.kind !== 'filter') worker.post(this.#listTask());
    }
    this.#worker.post(task);
  }

  #end(): void {
    this.#worker?.end();
    this.#worker = undefined;
  }

  readonly #take = (answer: TraceAnswer<F | FilePart>): void => {
    if ('list' in answer && answer.list !== this.#list && answer.kind !== 'timeline') return;
    batch(() => this.#hear(answer));
  };

  #hear(answer: TraceAnswer<F | FilePart>): void {
    const state = this.state.peek();
    const name = 'name' in state ? state.name : undefined;
    switch (answer.kind) {
      case 'progress':
        this.state.value = { kind: 'opening', name, percent: answer.percent };
        return;
      case 'opened':
        this.state.value = { kind: 'open', name, format: answer.format, clock: answer.clock };
        this.problems.value = { first: answer.problems, count: answer.problemCount };
        this.tabs.changed(true);
        return;
      case 'failed':
        this.#forget({ kind: 'failed', name, code: answer.code });
        return;
      case 'grown':
        this.summary.value = answer.summary;
        this.pieces.value = answer.pieces;
        this.causes.value = answer.causes;
        this.gone.value = answer.gone;
        this.tabs.changed(false);
        this.occurring.changed();
        return;
      case 'list':
        this.#rows.change(answer.from);
        this.rowsKept.value = answer.count;
        this.piecesKept.value = answer.pieces;
        this.filtering.value = !answer.done;
        this.filtered.value = answer.percent;
        if (answer.done) {
          this.marks.value = answer.marks;
          this.chosen.value = answer.chosen ?? -1;
          this.#show(answer.chosen);
          this.#askForFault();
          this.tabs.changed(answer.list !== this.#told);
          this.#told = answer.list;
        }
        this.revision.value++;
        return;
      case 'rows':
        this.#rows.keep(answer.from, answer.rows);
        this.revision.value++;
        return;
      case 'frame':
        if (this.#wanted?.row !== answer.row) return;
        this.record.value = answer.frame.index;
        this.about.value = answer.frame.about;
        this.#parts.show(answer.frame, this.#wanted.how);
        this.#wanted = undefined;
        return;
      case 'fault':
        if (answer.row !== undefined) this.choose(answer.row);
        this.#asks = false;
        this.#askForFault();
        return;
      case 'timeline':
      case 'tallies':
      case 'values':
        this.tabs.take(answer, this.#list);
        return;
      case 'occurring':
        this.occurring.take(answer.known);
        return;
      case 'exporting':
      case 'exported':
      case 'not-exported':
        this.exports.take(answer);
        return;
    }
  }

  /** Shows the frame that was sought, which is at a row of the list. */
  #show(row: number | undefined): void {
    const sought = this.#sought;
    this.#sought = undefined;
    if (sought === undefined) return;
    if (row === undefined) this.missing.value = sought;
    else this.choose(row, 'edit');
  }
}
