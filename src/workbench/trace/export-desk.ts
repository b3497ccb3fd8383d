import type { Profile } from '../../devices/index.ts';
import type { Trace } from '../../trace/index.ts';
import { type ExportAnswer, type ExportSource, type ExportTask, type ExportWords, exportSteps } from './export.ts';
import type { TraceList } from './trace-list.ts';

/** What holds the trace, and its list. */
interface Held {
  readonly trace: Trace;
  readonly list: TraceList;
  readonly filter: string;
  readonly profile: Profile | undefined;
  readonly clock: ExportSource['clock'];
  readonly zone: ExportSource['zone'];
  readonly words: ExportWords;
}

/** Makes files of the trace, a part at a time: one, and the last that is wanted. */
export class ExportDesk {
  readonly #held: () => Held;
  readonly #answer: (answer: ExportAnswer) => void;
  readonly #later: (act: () => void) => void;
  /** Of the file that is being made. */
  #order = -1;

  constructor(held: () => Held, answer: (answer: ExportAnswer) => void, later: (act: () => void) => void) {
    this.#held = held;
    this.#answer = answer;
    this.#later = later;
  }

  take(task: ExportTask): void {
    if (task.kind === 'no-export') this.stop();
    else this.#begin(task);
  }

  /** What is being made is not wanted any more. */
  stop(): void {
    this.#order = -1;
  }

  #begin(task: Extract<ExportTask, { kind: 'export' }>): void {
    const { order, wanted, ofFiltered, source } = task;
    if (wanted.format === 'report' && this.#held().words.report === undefined) {
      this.#answer({ kind: 'not-exported', order });
      return;
    }
    this.#order = order;
    let percent = 0;
    this.#answer({ kind: 'exporting', order, percent });
    let steps: ReturnType<typeof exportSteps> | undefined;
    let frames = 0;
    const go = () => {
      if (this.#order !== order) return;
      const { trace, list, filter, profile, clock, zone, words } = this.#held();
      // What the filter keeps is known once it has looked at everything.
      if (steps === undefined && (!ofFiltered || list.done)) {
        const indexes = ofFiltered ? list.records() : undefined;
        frames = ofFiltered ? (indexes?.length ?? 0) - list.pieces : trace.size - trace.pieces;
        steps = exportSteps({ trace, indexes, source, filter, profile, clock, zone }, wanted, words);
      }
      const step = steps?.next();
      if (step?.done) {
        this.#order = -1;
        this.#answer({ kind: 'exported', order, frames, parts: step.value });
        return;
      }
      const done = Math.floor(100 * (step?.value ?? 0));
      if (done > percent) this.#answer({ kind: 'exporting', order, percent: done });
      percent = Math.max(percent, done);
      this.#later(go);
    };
    go();
  }
}
