import digest from './digest-worker.ts?worker&url';
import reader from './reading-worker.ts?worker&url';
import session from './session-worker.ts?worker&url';
import trace from './trace-worker.ts?worker&url';
import { ALIVE } from './worker-alive.ts';

/** Why a worker does nothing any more: its script did not come, it ended by itself, or this page may have none. */
export type WorkerEnd = 'not-loaded' | 'died' | 'forbidden';

export interface Running<Task> {
  /** Does nothing after the worker has ended. */
  post(task: Task): void;
  /** Ends it; nothing is heard of it afterwards. */
  end(): void;
}

const addresses = { digest, session, reader, trace } as const;

/** The browser's guard against scripts from elsewhere, where it has one. */
interface TrustedTypes {
  createPolicy(
    name: string,
    rules: { createScriptURL(address: string): string },
  ): {
    createScriptURL(address: string): string;
  };
}

const policy = (globalThis as { trustedTypes?: TrustedTypes }).trustedTypes?.createPolicy('framewright', {
  createScriptURL(address) {
    if (Object.values(addresses).includes(address)) return address;
    throw new TypeError(`No worker of this page: ${address}`);
  },
});

/**
 * Starts a worker. Its answers come to `take`. Where it does not come, dies or is forbidden, `ended` is called, once and
 * never before this has returned; the worker is gone then.
 */
export function startWorker<Task, Answer>(
  which: keyof typeof addresses,
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
    const address = addresses[which];
    const name = `framewright-${which}-${Math.random()}`;
    worker = new Worker(policy?.createScriptURL(address) ?? address, { type: 'module', name });
    worker.onmessage = ({ data }: MessageEvent<Answer | typeof ALIVE>) => {
      if (data === ALIVE) begin(name);
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
