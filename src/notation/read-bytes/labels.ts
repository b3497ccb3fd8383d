import type { ChunkWord } from './chunk-words.ts';
import type { Furniture } from './furniture.ts';
import { LineScanner, type Sink } from './scan-line.ts';
import type { ChunkLabel } from './types.ts';

/** The most characters of a line that are looked through for what they say of the bytes behind them. */
const MOST = 400;

/** Gathers what stands before the bytes of a line. */
class LabelSink implements Sink {
  found: ChunkLabel = {};
  readonly #line: string;

  constructor(line: string) {
    this.#line = line;
  }

  chunkWord(word: ChunkWord): void {
    this.found = { ...this.found, ...word };
  }

  furniture(start: number, end: number, kind: Furniture['kind']): boolean {
    if (kind === 'time') this.found = { ...this.found, time: this.#line.slice(start, end) };
    return true;
  }

  number(): void {}
  oddity(): void {}
  leftOut(): void {}
  word(): void {}
  label(): void {}
  bracket(): void {}
  again(): boolean {
    return false;
  }
}

/** What the beginning of a line says of the bytes that follow it. */
export function labelOf(before: string): ChunkLabel {
  if (before.trim() === '') return {};
  const line = before.slice(-MOST);
  const sink = new LabelSink(line);
  new LineScanner(line, 0, sink).scan();
  return sink.found;
}
