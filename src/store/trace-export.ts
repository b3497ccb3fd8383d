import { type Signal, signal } from '@preact/signals-core';
import type { ExportAnswer, ExportTask, FilePart } from '../workbench/index.ts';

/** A file that was made of a trace: its pieces, and how many frames are in it. */
export interface ExportedFile<F> {
  readonly frames: number;
  readonly parts: readonly (F | FilePart)[];
}

/** Why there is no file: it was given up, or could not be made. */
export type NotExported = 'given-up' | 'failed';

type Wanted = Omit<Extract<ExportTask, { kind: 'export' }>, 'kind' | 'order'>;

/** Lets what holds a trace make files of it, one at a time. */
export class TraceExport<F> {
  /** How much of the file has been made, in percent; `undefined` if none is being made. */
  readonly percent: Signal<number | undefined> = signal(undefined);
  readonly #post: (task: ExportTask) => void;
  #order = 0;
  #ends: ((file: ExportedFile<F> | NotExported) => void) | undefined;

  constructor(post: (task: ExportTask) => void) {
    this.#post = post;
  }

  /** Makes a file. One that is still being made is given up. */
  make(wanted: Wanted): Promise<ExportedFile<F> | NotExported> {
    this.#end('given-up');
    this.percent.value = 0;
    return new Promise((resolve) => {
      this.#ends = resolve;
      this.#post({ kind: 'export', order: ++this.#order, ...wanted });
    });
  }

  /** Gives up what is being made. */
  readonly cancel = (): void => {
    if (this.#ends === undefined) return;
    this.#post({ kind: 'no-export' });
    this.#end('given-up');
  };

  /** The trace is another one: what is being made of it does not come. */
  forget(): void {
    this.#end('given-up');
  }

  take(answer: ExportAnswer<F | FilePart>): void {
    if (answer.order !== this.#order || this.#ends === undefined) return;
    if (answer.kind === 'exporting') this.percent.value = answer.percent;
    else if (answer.kind === 'not-exported') this.#end('failed');
    else this.#end({ frames: answer.frames, parts: answer.parts });
  }

  #end(file: ExportedFile<F> | NotExported): void {
    this.percent.value = undefined;
    this.#ends?.(file);
    this.#ends = undefined;
  }
}
