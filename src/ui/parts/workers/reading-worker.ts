import type { ByteNotation } from '../../../notation/index.ts';
import { readText } from '../../../workbench/index.ts';
import { sayAlive } from './worker-alive.ts';

const { postMessage } = globalThis as unknown as Worker;

/** Reads long texts off the main thread: one message in; out come the percent that are done, and then what was read. */
addEventListener('message', ({ data }: MessageEvent<{ text: string; as: ByteNotation | undefined }>) => {
  const reading = readText(data.text, data.as, (percent) => postMessage(percent));
  const transfer = [reading.origin.buffer as ArrayBuffer];
  postMessage(reading, transfer);
});
sayAlive();
