import digest from './digest-worker.ts?worker&url';
import session from './session-worker.ts?worker&url';
import trace from './trace-worker.ts?worker&url';

const addresses = { digest, session, trace } as const;

export type WorkerName = keyof typeof addresses;

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

/** A worker of this page's script, which the page's one policy lets through. */
export function makeWorker(which: WorkerName, name: string): Worker {
  const address = addresses[which];
  return new Worker(policy?.createScriptURL(address) ?? address, { type: 'module', name });
}
