import type { Checksum } from '../../modbus/index.ts';
import {
  type ChecksumValues,
  type DigestedInput,
  type DigestedPart,
  digestInput,
  type InputKind,
  type InputReading,
  joinedValues,
  type ToldChecksum,
  tellChecksum,
  toldChecksum,
} from '../../workbench/index.ts';
import type { Answer, Task } from '../parts/workers/digest-task.ts';
import { type Running, startWorker } from '../parts/workers/start-worker.ts';

/** What checksums are taken over. */
export type Source =
  | { readonly kind: 'typed'; readonly text: string; readonly as: InputKind }
  | { readonly kind: 'file'; readonly file: File };

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
export const MOST_WHOLE = 2 ** 20;
/** Larger files, in bytes, are worth more than one worker. */
const WORTH_PARTS = 2 ** 25;
const MOST_PARTS = 4;
/** What is calculated of a large file besides the chosen algorithm. */
const ALWAYS = ['CRC-16/MODBUS', 'LRC'];

/** Calculates checksums, long ones in workers. Its answer is always about the source that was asked for last. */
export class Digester {
  private source: Source | undefined;
  private digest: Digest = { kind: 'cancelled' };
  private workers: Running<Task>[] = [];
  private readonly changed: () => void;

  /** `changed` is called when more is known. */
  constructor(changed: () => void) {
    this.changed = changed;
  }

  /** What is known of the checksums of a source, `chosen` among them. If asked again, it continues what it has begun. */
  of(source: Source, chosen: Checksum): Digest {
    if (!isSame(source, this.source)) this.begin(source, chosen);
    else if (this.digest.kind === 'done' && source.kind === 'file' && this.digest.reading === undefined) {
      if (this.digest.values[chosen.name] === undefined) {
        this.beginParts(source.file, [tellChecksum(chosen)], this.digest.values);
      }
    }
    return this.digest;
  }

  /** Gives up; what was known before is gone too. */
  readonly cancel = (): void => {
    this.stop();
    this.tell({ kind: 'cancelled' });
  };

  stop(): void {
    for (const worker of this.workers) worker.end();
    this.workers = [];
  }

  /** Forgets the source, so that it is read again. */
  readonly again = (): void => {
    this.source = undefined;
    this.changed();
  };

  private begin(source: Source, chosen: Checksum): void {
    this.stop();
    this.source = source;
    if (source.kind === 'typed') {
      if (source.text.length <= LONG) this.digest = doneWith(digestInput(source.text, source.as));
      else this.beginWhole({ kind: 'text', text: source.text, as: source.as }, source.text.length);
    } else if (source.file.size <= MOST_WHOLE) {
      this.beginWhole({ kind: 'file', file: source.file }, source.file.size);
    } else {
      this.beginParts(source.file, [...ALWAYS.filter((name) => name !== chosen.name), tellChecksum(chosen)], {});
    }
  }

  private beginWhole(task: Task, size: number): void {
    this.digest = { kind: 'computing', done: 0, size, speed: undefined, values: {} };
    this.ask(task, (answer) => {
      if (answer.kind !== 'whole') return;
      this.stop();
      this.tell(doneWith(answer));
    });
  }

  /** Parts of the file side by side, where the checksums can be joined. */
  private beginParts(file: File, algorithms: readonly ToldChecksum[], known: ChecksumValues): void {
    this.stop();
    const checksums = algorithms.map(toldChecksum);
    const begun = performance.now();
    const speedOf = (bytes: number) => (1000 * bytes) / Math.max(1, performance.now() - begun);
    const joined = checksums.every(({ join }) => join) && file.size >= WORTH_PARTS;
    const count = joined ? Math.min(MOST_PARTS, navigator.hardwareConcurrency || 1) : 1;
    const each = Math.ceil(file.size / count);
    const parts = Array.from({ length: count }, (_, n) => file.slice(n * each, (n + 1) * each));
    const states = new Map<number, DigestedPart>();
    let done = 0;
    this.digest = { kind: 'computing', done, size: file.size, speed: undefined, values: known };
    parts.forEach((part, n) => {
      this.ask({ kind: 'part', file: part, first: n === 0, algorithms }, (answer) => {
        if (answer.kind === 'progress') {
          done += answer.bytes;
          this.tell({ kind: 'computing', done, size: file.size, speed: speedOf(done), values: known });
        }
        if (answer.kind !== 'part') return;
        states.set(n, { states: answer.states, size: part.size });
        if (states.size < count) return;
        const inOrder = parts.flatMap((_, index) => states.get(index) ?? []);
        this.stop();
        this.tell({
          kind: 'done',
          size: file.size,
          reading: undefined,
          values: { ...known, ...joinedValues(checksums, inOrder) },
          speed: speedOf(file.size),
        });
      });
    });
  }

  private ask(task: Task, take: (answer: Answer) => void): void {
    const fail = () => {
      this.stop();
      this.tell({ kind: 'failed' });
    };
    const answered = (answer: Answer) => (answer.kind === 'failed' ? fail() : take(answer));
    const worker = startWorker<Task, Answer>('digest', answered, fail);
    this.workers.push(worker);
    worker.post(task);
  }

  private tell(digest: Digest): void {
    this.digest = digest;
    this.changed();
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
