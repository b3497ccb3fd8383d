import { afterEach, describe, expect, it, vi } from 'vitest';
import { bytesOf, streamOf } from '../../../src/ui/parts/workers/file-bytes.ts';

const SLICE = 2 ** 22;

/** A file that only the window reads. */
class Refused extends Blob {
  override arrayBuffer = () => Promise.reject(new DOMException('The I/O read operation failed.', 'NotReadableError'));
  override slice = (from?: number, to?: number): Refused => new Refused([super.slice(from, to)]);
  read = () => super.arrayBuffer();
}

/** Plays the window, which reads or cannot; the sizes of what it was asked for. */
function window(reads: boolean): number[] {
  const asked: number[] = [];
  vi.stubGlobal('postMessage', (slice: Refused, [port]: [MessagePort]) => {
    asked.push(slice.size);
    if (!reads) port.postMessage(undefined);
    else void slice.read().then((bytes) => port.postMessage(bytes, [bytes]));
  });
  return asked;
}

function some(size: number): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(size);
  for (let at = 0; at < size; at += 1009) bytes[at] = at % 251;
  return bytes;
}

afterEach(() => vi.unstubAllGlobals());

describe('the bytes of a file in a worker', () => {
  it('are read by the worker itself where it may', async () => {
    const asked = window(true);
    expect(await bytesOf(new Blob([some(5)]))).toEqual(some(5));
    expect(asked).toEqual([]);
  });

  it.each([1, SLICE, 2 * SLICE + 7])('are read by the window where it may not: %i bytes', async (size) => {
    const asked = window(true);
    expect(Buffer.compare(await bytesOf(new Refused([some(size)])), some(size))).toBe(0);
    expect(asked.every((one) => one <= SLICE)).toBe(true);
    expect(asked.reduce((sum, one) => sum + one, 0)).toBe(size);
  });

  it('come as a stream, too', async () => {
    window(true);
    const lengths: number[] = [];
    for await (const piece of await streamOf(new Refused([some(SLICE + 3)]))) lengths.push(piece.length);
    expect(lengths).toEqual([SLICE, 3]);
  });

  it('are refused where nobody can read them', async () => {
    window(false);
    await expect(bytesOf(new Refused([some(3)]))).rejects.toThrow();
  });
});
