import { joinBytes } from '../../../modbus/index.ts';
import { demoLog, type OwnLog, type TraceFailure, type TraceSource } from '../../../workbench/index.ts';
import { bytesOf, streamOf } from './file-bytes.ts';

/** Most bytes that are read of a file, packed or not. */
const MOST = 2 ** 30;

/** The logs that the page has itself. */
const texts: Readonly<Record<OwnLog, () => string>> = { demo: demoLog };

/** All bytes of a source, unpacked if it is gzipped; or why they did not come. */
export async function readSource(source: TraceSource<File>): Promise<Uint8Array | TraceFailure> {
  if (source.kind !== 'file')
    return new TextEncoder().encode(source.kind === 'text' ? source.text : texts[source.log]());
  const { file } = source;
  if (file.size > MOST) return 'too-large';
  try {
    const [first, second] = await bytesOf(file.slice(0, 2));
    if (first !== 0x1f || second !== 0x8b) return await bytesOf(file);
    const packed = await streamOf(file);
    return await joined(packed.pipeThrough(new DecompressionStream('gzip')));
  } catch {
    return 'unreadable';
  }
}

/** The bytes of a stream in one piece; of one that is cut off, those that came. */
async function joined(stream: ReadableStream<Uint8Array>): Promise<Uint8Array | TraceFailure> {
  const chunks: Uint8Array[] = [];
  let size = 0;
  const reader = stream.getReader();
  const next = () =>
    reader.read().catch((error: unknown) => {
      if (size === 0) throw error;
      return { done: true } as const;
    });
  for (let read = await next(); !read.done; read = await next()) {
    chunks.push(read.value);
    size += read.value.length;
    if (size <= MOST) continue;
    await reader.cancel();
    return 'too-large';
  }
  return joinBytes(chunks);
}
