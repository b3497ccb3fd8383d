import type { ByteNotation, Chunk, ChunkLabel, TextProblem, TextRange } from './types.ts';

/** Collects what a notation reads. */
export class Output {
  readonly origin: TextRange[] = [];
  readonly problems: TextProblem[] = [];
  readonly chunks: (Chunk & { to: number })[] = [];
  #room = new Uint8Array(256);

  get bytes(): Uint8Array {
    return this.#room.slice(0, this.origin.length);
  }

  get length(): number {
    return this.origin.length;
  }

  byte(value: number, start: number, end: number): void {
    const { length } = this.origin;
    if (length === this.#room.length) {
      const wider = new Uint8Array(2 * length);
      wider.set(this.#room);
      this.#room = wider;
    }
    this.#room[length] = value;
    this.origin.push({ start, end });
  }

  /** Ends a chunk that began at byte `from`, if it has any. */
  chunk(from: number, label: ChunkLabel, reading?: ByteNotation): void {
    if (this.length === from) return;
    const chunk = { from, to: this.length, ...label };
    this.chunks.push(reading === undefined ? chunk : { ...chunk, reading });
  }

  /** Ends a chunk that goes on with the one before. */
  extendChunk(from: number): void {
    const last = this.chunks.at(-1);
    if (last === undefined) this.chunk(from, {});
    else last.to = this.length;
  }
}
