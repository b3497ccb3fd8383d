import { joinBytes } from '../../../modbus/index.ts';

/** Bytes that are asked of the window at a time. */
const SLICE = 2 ** 22;

/**
 * The bytes of a file, or of a part of one, in a worker. Where the browser lets no worker read files, as WebKit does on a page
 * from a disk, the window reads them, a slice at a time (`start-worker.ts`). Rejects if they do not come.
 */
export async function bytesOf(file: Blob): Promise<Uint8Array<ArrayBuffer>> {
  if (await isReadHere(file)) return new Uint8Array(await file.arrayBuffer());
  const slices: Uint8Array[] = [];
  const reader = slicesOf(file).getReader();
  for (let read = await reader.read(); !read.done; read = await reader.read()) slices.push(read.value);
  return joinBytes(slices);
}

/** The same, piece by piece. */
export const streamOf = async (file: Blob): Promise<ReadableStream<Uint8Array<ArrayBuffer>>> =>
  (await isReadHere(file)) ? file.stream() : slicesOf(file);

const isReadHere = (file: Blob): Promise<boolean> =>
  file
    .slice(0, 1)
    .arrayBuffer()
    .then(
      () => true,
      () => false,
    );

function slicesOf(file: Blob): ReadableStream<Uint8Array<ArrayBuffer>> {
  let at = 0;
  return new ReadableStream({
    async pull(controller) {
      if (at >= file.size) return controller.close();
      const bytes = await lent(file.slice(at, at + SLICE));
      at += SLICE;
      controller.enqueue(new Uint8Array(bytes));
    },
  });
}

function lent(slice: Blob): Promise<ArrayBuffer> {
  const { port1, port2 } = new MessageChannel();
  (globalThis as unknown as Worker).postMessage(slice, [port2]);
  return new Promise((resolve, reject) => {
    port1.onmessage = ({ data }: MessageEvent<ArrayBuffer | undefined>) => {
      port1.close();
      if (data) resolve(data);
      else reject(new Error('The window cannot read it either.'));
    };
  });
}
