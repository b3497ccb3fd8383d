import {
  checksumValues,
  type DigestAnswer,
  type DigestTask,
  digestInput,
  toldChecksum,
} from '../../../workbench/index.ts';
import { bytesOf, streamOf } from './file-bytes.ts';
import { sayAlive } from './worker-alive.ts';

/** Bytes read at a time, into the same memory: reading into new memory each time takes three times as long. */
const CHUNK = 2 ** 20;
/** Progress is told at most so often, in milliseconds. */
const OFTEN = 200;

const answer = (message: DigestAnswer) => (globalThis as unknown as Worker).postMessage(message);

addEventListener('message', ({ data }: MessageEvent<DigestTask<Blob>>) => {
  void work(data).catch(() => answer({ kind: 'failed' }));
});
sayAlive();

async function work(task: DigestTask<Blob>): Promise<void> {
  switch (task.kind) {
    case 'text':
      return answer({ kind: 'whole', ...digestInput(task.text, task.as) });
    case 'file': {
      const bytes = await bytesOf(task.file);
      return answer({ kind: 'whole', reading: { bytes, problems: [] }, values: checksumValues(bytes) });
    }
    case 'part':
      return answer({ kind: 'part', states: await statesAfter(task) });
  }
}

async function statesAfter({
  file,
  first,
  algorithms,
}: Extract<DigestTask<Blob>, { kind: 'part' }>): Promise<number[]> {
  const checksums = algorithms.map(toldChecksum);
  const states = checksums.map(({ start }) => (first ? start : 0));
  let untold = 0;
  let told = performance.now();
  for await (const bytes of chunksOf(file)) {
    checksums.forEach((one, index) => {
      states[index] = one.add(states[index] as number, bytes);
    });
    untold += bytes.length;
    if (performance.now() - told < OFTEN) continue;
    answer({ kind: 'progress', bytes: untold });
    untold = 0;
    told = performance.now();
  }
  return states;
}

/** The bytes of a file in order; each piece is good until the next is asked for. */
async function* chunksOf(file: Blob): AsyncGenerator<Uint8Array> {
  const stream = await streamOf(file);
  const reader = byobReader(stream);
  if (reader === undefined) {
    const plain = stream.getReader();
    for (let read = await plain.read(); !read.done; read = await plain.read()) yield read.value;
    return;
  }
  let memory = new ArrayBuffer(CHUNK);
  for (;;) {
    const { done, value } = await reader.read(new Uint8Array(memory));
    if (done) return;
    yield value;
    memory = value.buffer;
  }
}

/** Not every browser lets a file be read into given memory. */
function byobReader(stream: ReadableStream<Uint8Array<ArrayBuffer>>): ReadableStreamBYOBReader | undefined {
  try {
    return stream.getReader({ mode: 'byob' });
  } catch {
    return undefined;
  }
}
