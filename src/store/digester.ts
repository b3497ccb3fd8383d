import { type Signal, signal } from '@preact/signals-core';
import type { Checksum } from '../modbus/index.ts';
import {
  type ChecksumValues,
  type DigestAnswer,
  type DigestedInput,
  type DigestedPart,
  type DigestTask,
  digestInput,
  type InputKind,
  type InputReading,
  joinedValues,
  type ToldChecksum,
  tellChecksum,
  toldChecksum,
} from '../workbench/index.ts';

/** A part of a file, or all of it. */
export interface FilePart {
  readonly size: number;
}

/** A file as a browser hands it over. */
export interface WholeFile extends FilePart {
  readonly name: string;
  slice(from: number, to: number): FilePart;
}

/** What checksums are taken over. */
export type Source =
  | { readonly kind: 'typed'; readonly text: string; readonly as: InputKind }
  | { readonly kind: 'file'; readonly file: WholeFile };

/** What calculates beside the page. */
export interface DigestWorkers {
  /** Starts one with a task. Its answers come to `take`; `ended` is called if it can give none. Answers how to end it. */
  start(task: DigestTask<FilePart>, take: (answer: DigestAnswer) => void, ended: () => void): () => void;
  /** How many are of use at a time. */
  readonly most: number;
  /** Milliseconds on a clock of any beginning. */
  now(): number;
}

/** How far it is: nothing is said of bytes that are still being read. */
export type Digest =
  | {
      readonly kind: 'computing';
      readonly done: number;
      readonly size: number;
      readonly speed: number | undefined;
      /** What was calculated from the same bytes before. */
      readonly values: ChecksumValues;
    }
  | {
      readonly kind: 'done';
      readonly size: number;
      /** Absent for a file too large to be held in memory. */
      readonly reading: InputReading | undefined;
      readonly values: ChecksumValues;
      /** Bytes a second, where it took long enough to be told. */
      readonly speed: number | undefined;
    }
  | { readonly kind: 'failed' }
  | { readonly kind: 'cancelled' };

/** Longer texts, in characters, are read off the main thread. */
const LONG = 20_000;
/** Larger files, in bytes, are not held in memory, and have only the checksums that are asked for. */
const MOST_WHOLE = 2 ** 20;
/** Larger files, in bytes, are worth more than one worker. */
const WORTH_PARTS = 2 ** 25;
const MOST_PARTS = 4;
/** What is calculated of a large file besides the chosen algorithm. */
const ALWAYS = ['CRC-16/MODBUS', 'LRC'];

/** Calculates checksums, long ones in workers. Its answer is always about the source that was asked for last. */
export class Digester {
  /** What is known of the source that was given last. */
  readonly digest: Signal<Digest> = signal({ kind: 'cancelled' });
  readonly #workers: DigestWorkers;
  #source: Source | undefined;
  #chosen: Checksum | undefined;
  #ends: (() => void)[] = [];

  constructor(workers: DigestWorkers) {
    this.#workers = workers;
  }

  /** Calculates the checksums of a source, `chosen` among them. If it is the same source, what has begun continues. */
  take(source: Source, chosen: Checksum): void {
    this.#chosen = chosen;
    const known = this.digest.peek();
    if (!isSame(source, this.#source)) this.#begin(source, chosen);
    else if (known.kind === 'done' && source.kind === 'file' && known.reading === undefined) {
      if (known.values[chosen.name] === undefined) this.#beginParts(source.file, [tellChecksum(chosen)], known.values);
    }
  }

  /** Gives up; what was known before is gone too. */
  readonly cancel = (): void => {
    this.stop();
    this.digest.value = { kind: 'cancelled' };
  };

  /** Ends what calculates. */
  stop(): void {
    for (const end of this.#ends.splice(0)) end();
  }

  /** Reads the source once more. */
  readonly again = (): void => {
    if (this.#source && this.#chosen) this.#begin(this.#source, this.#chosen);
  };

  #begin(source: Source, chosen: Checksum): void {
    this.stop();
    this.#source = source;
    if (source.kind === 'typed') {
      if (source.text.length <= LONG) this.digest.value = doneWith(digestInput(source.text, source.as));
      else this.#beginWhole({ kind: 'text', text: source.text, as: source.as }, source.text.length);
    } else if (source.file.size <= MOST_WHOLE) {
      this.#beginWhole({ kind: 'file', file: source.file }, source.file.size);
    } else {
      this.#beginParts(source.file, [...ALWAYS.filter((name) => name !== chosen.name), tellChecksum(chosen)], {});
    }
  }

  #beginWhole(task: DigestTask<FilePart>, size: number): void {
    this.digest.value = { kind: 'computing', done: 0, size, speed: undefined, values: {} };
    this.#ask(task, (answer) => {
      if (answer.kind !== 'whole') return;
      this.stop();
      this.digest.value = doneWith(answer);
    });
  }

  /** Parts of the file side by side, where the checksums can be joined. */
  #beginParts(file: WholeFile, algorithms: readonly ToldChecksum[], known: ChecksumValues): void {
    this.stop();
    const checksums = algorithms.map(toldChecksum);
    const begun = this.#workers.now();
    const speedOf = (bytes: number) => (1000 * bytes) / Math.max(1, this.#workers.now() - begun);
    const joined = checksums.every(({ join }) => join) && file.size >= WORTH_PARTS;
    const count = joined ? Math.min(MOST_PARTS, this.#workers.most) : 1;
    const each = Math.ceil(file.size / count);
    const parts = Array.from({ length: count }, (_, n) => file.slice(n * each, (n + 1) * each));
    const states = new Map<number, DigestedPart>();
    let done = 0;
    this.digest.value = { kind: 'computing', done, size: file.size, speed: undefined, values: known };
    parts.forEach((part, n) => {
      this.#ask({ kind: 'part', file: part, first: n === 0, algorithms }, (answer) => {
        if (answer.kind === 'progress') {
          done += answer.bytes;
          this.digest.value = { kind: 'computing', done, size: file.size, speed: speedOf(done), values: known };
        }
        if (answer.kind !== 'part') return;
        states.set(n, { states: answer.states, size: part.size });
        if (states.size < count) return;
        const inOrder = parts.flatMap((_, index) => states.get(index) ?? []);
        this.stop();
        this.digest.value = {
          kind: 'done',
          size: file.size,
          reading: undefined,
          values: { ...known, ...joinedValues(checksums, inOrder) },
          speed: speedOf(file.size),
        };
      });
    });
  }

  #ask(task: DigestTask<FilePart>, take: (answer: DigestAnswer) => void): void {
    const fail = () => {
      this.stop();
      this.digest.value = { kind: 'failed' };
    };
    this.#ends.push(this.#workers.start(task, (answer) => (answer.kind === 'failed' ? fail() : take(answer)), fail));
  }
}

const doneWith = ({ reading, values }: DigestedInput): Digest => ({
  kind: 'done',
  size: reading.bytes.length,
  reading,
  values,
  speed: undefined,
});

function isSame(one: Source, other: Source | undefined): boolean {
  if (one.kind === 'file') return other?.kind === 'file' && other.file === one.file;
  return other?.kind === 'typed' && other.text === one.text && other.as === one.as;
}
