import { acceptHex } from './fields/raw-bytes.ts';
import { fromHex } from './hex.ts';

/** Longer than any legal frame, so that only forced ones make it grow. */
const USUAL = 1024;

/**
 * Bytes written one after another. One of these serves every frame: it is much cheaper to copy a frame out at the end than
 * to compute its length first.
 */
export class Output {
  bytes = new Uint8Array(USUAL);
  length = 0;

  /** Makes room for `size` more bytes; answers where they begin. */
  grow(size: number): number {
    const at = this.length;
    this.length = at + size;
    if (this.length > this.bytes.length) {
      const larger = new Uint8Array(2 * this.length);
      larger.set(this.bytes.subarray(0, at));
      this.bytes = larger;
    }
    return at;
  }

  u8(value: number): void {
    const at = this.grow(1);
    this.bytes[at] = value;
  }

  /** High byte first. */
  u16(value: number): void {
    const at = this.grow(2);
    this.bytes[at] = value >>> 8;
    this.bytes[at + 1] = value & 0xff;
  }

  /** Bytes given as hexadecimal pairs; throws a `FrameError` naming `path` for anything else. */
  pairs(text: unknown, path: string): void {
    const bytes = fromHex(acceptHex(text, path)) as Uint8Array;
    const at = this.grow(bytes.length);
    this.bytes.set(bytes, at);
  }

  /** A copy of what was written. */
  take(): Uint8Array {
    return this.bytes.slice(0, this.length);
  }
}
