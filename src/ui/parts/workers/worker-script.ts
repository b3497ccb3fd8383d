import digest from './digest-worker.ts?worker&url';
import maps from './maps-worker.ts?worker&url';
import session from './session-worker.ts?worker&url';
import trace from './trace-worker.ts?worker&url';

const addresses = { digest, maps, session, trace } as const;

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

/** Keeps the page offline: `scripts/offline` writes it beside the page. */
const OFFLINE = './offline-worker.js';

const policy = (globalThis as { trustedTypes?: TrustedTypes }).trustedTypes?.createPolicy('framewright', {
  createScriptURL(address) {
    if (address === OFFLINE || Object.values(addresses).includes(address)) return address;
    throw new TypeError(`No worker of this page: ${address}`);
  },
});

const trusted = (address: string): string => policy?.createScriptURL(address) ?? address;

export const offlineWorker = trusted(OFFLINE);

/** A worker of this page's script, which the page's one policy lets through. */
export function makeWorker(which: WorkerName, name: string): Worker {
  return new Worker(trusted(addresses[which]), { type: 'module', name });
}
