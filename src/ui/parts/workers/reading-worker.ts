import type { ByteNotation } from '../../../notation/index.ts';
import { readText } from '../../../workbench/index.ts';
import { sayAlive } from './worker-alive.ts';

/** Reads long texts off the main thread: one message in, one out. */
addEventListener('message', ({ data }: MessageEvent<{ text: string; as: ByteNotation | undefined }>) => {
  const reading = readText(data.text, data.as);
  const transfer = [reading.origin.buffer as ArrayBuffer];
  (globalThis as unknown as Worker).postMessage(reading, transfer);
});
sayAlive();
