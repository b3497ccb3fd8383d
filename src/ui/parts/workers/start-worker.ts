import type { WorkerEnd } from '../../../bus/index.ts';
import { ALIVE } from './worker-alive.ts';
import { makeWorker, type WorkerName } from './worker-script.ts';

export interface Running<Task> {
  /** Does nothing after the worker has ended. */
  post(task: Task): void;
  /** Ends it; nothing is heard of it afterwards. */
  end(): void;
}

/**
 * Starts a worker. Its answers come to `take`. Where it does not come, dies or is forbidden, `ended` is called, once and
 * never before this has returned; the worker is gone then.
 */
export function startWorker<Task, Answer>(
  which: WorkerName,
  take: (answer: Answer) => void,
  ended: (why: WorkerEnd) => void,
): Running<Task> {
  const watch = new AbortController();
  let worker: Worker | undefined;
  let alive = false;
  const waiting: Task[] = [];

  const end = () => {
    watch.abort();
    worker?.terminate();
    worker = undefined;
  };
  const fail = (why: WorkerEnd) => {
    if (watch.signal.aborted) return;
    end();
    ended(why);
  };

  /** A worker holds a lock as long as it lives: no event tells of one that the browser ends, for want of memory perhaps. */
  const begin = (name: string) => {
    alive = true;
    const { signal } = watch;
    navigator.locks?.request(name, { signal }, () => fail('died')).catch(() => undefined);
    for (const task of waiting.splice(0)) worker?.postMessage(task);
  };

  try {
    const name = `framewright-${which}-${Math.random()}`;
    worker = makeWorker(which, name);
    worker.onmessage = ({ data, ports: [port] }: MessageEvent) => {
      if (port) lend(data, port);
      else if (data === ALIVE) begin(name);
      else take(data);
    };
    worker.onerror = () => fail(alive ? 'died' : 'not-loaded');
  } catch {
    queueMicrotask(() => fail('forbidden'));
  }
  return {
    // What keeps a worker busy from its first moment would keep it from saying that it lives.
    post: (task) => (alive ? worker?.postMessage(task) : waiting.push(task)),
    end,
  };
}

/** Reads a slice of a file for a worker that may not (`file-bytes.ts`), and answers to the port that came with it. */
const lend = (slice: Blob, port: MessagePort): Promise<void> =>
  slice.arrayBuffer().then(
    (bytes) => port.postMessage(bytes, [bytes]),
    () => port.postMessage(undefined),
  );
