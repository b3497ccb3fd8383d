import { basename, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Worker as Thread } from 'node:worker_threads';
import { builtFolder } from './built.ts';
import { Locks } from './locks.ts';

/** What a worker's script finds in a browser, and not in a thread. */
const PRELUDE = `
const { parentPort, workerData } = require('node:worker_threads');
globalThis.name = workerData.name;
const locks = { request: (_, hold) => Promise.resolve().then(hold) };
Object.defineProperty(globalThis, 'navigator', { value: { languages: ['en'], locks }, configurable: true });
globalThis.reportError = (error) => console.error(error);
globalThis.postMessage = (data, ports = []) => parentPort.postMessage({ data, ports }, ports);
globalThis.addEventListener = (_, hear) => parentPort.on('message', (data) => hear({ data }));
import(workerData.script);
`;

/** The page's workers, each in a thread. */
export class DrawnWorker {
  static readonly #all = new Set<DrawnWorker>();
  /** Of the window; a worker has the one of its own name as long as it lives. */
  static locks = new Locks();
  readonly #thread: Thread;
  onmessage: ((event: { data: unknown; ports: unknown[] }) => void) | undefined;
  onerror: (() => void) | undefined;

  constructor(address: string, { name }: { name?: string } = {}) {
    const script = resolve(builtFolder, basename(address));
    this.#thread = new Thread(PRELUDE, { eval: true, workerData: { name, script: pathToFileURL(script).href } });
    this.#thread.on('message', ({ data, ports }) => this.onmessage?.({ data, ports }));
    this.#thread.on('error', () => this.onerror?.());
    DrawnWorker.#all.add(this);
    const ended = new Promise<void>((resolve) => {
      // What ends with its window is told to nobody.
      this.#thread.on('exit', () => DrawnWorker.#all.delete(this) && resolve());
    });
    if (name !== undefined) void DrawnWorker.locks.request(name, () => ended);
  }

  postMessage(data: unknown, ports: readonly never[] = []): void {
    this.#thread.postMessage(data, ports);
  }

  terminate(): void {
    void this.#thread.terminate();
  }

  static async endAll(): Promise<void> {
    const all = [...DrawnWorker.#all];
    DrawnWorker.#all.clear();
    DrawnWorker.locks = new Locks();
    await Promise.all(all.map((worker) => worker.#thread.terminate()));
  }
}
