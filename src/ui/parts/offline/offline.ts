import type { Vocabulary } from '../../../words/index.ts';
import { openFile } from '../pasted.ts';
import { offlineWorker } from '../workers/worker-script.ts';

/** A window that was opened with files, in browsers that let a page open kinds of files. */
interface LaunchQueue {
  setConsumer(take: (launch: { readonly files: readonly FileSystemFileHandle[] }) => void): void;
}

const later = () => import('./later.ts');

/**
 * Has the browser keep the page, so that it works offline, and takes what the page was opened with from outside: files,
 * and what another program shared. Where the browser keeps nothing, the page goes on without.
 */
export async function keepOffline(vocabulary: Vocabulary): Promise<void> {
  const { serviceWorker } = navigator;
  // The one file has none: it is its own copy.
  if (!serviceWorker || !document.querySelector('[rel=manifest]')) return;
  const { launchQueue } = window as { launchQueue?: LaunchQueue };
  launchQueue?.setConsumer(({ files: [file] }) => file?.getFile().then(openFile));
  if (location.search === '?shared') later().then(({ takeShared }) => takeShared());
  const registration = await serviceWorker.register(offlineWorker, { updateViaCache: 'none' }).catch(() => undefined);
  const offer = () => {
    const newer = registration?.waiting;
    // The first that is kept is the version that runs.
    if (newer && serviceWorker.controller) later().then(({ offerVersion }) => offerVersion(newer, vocabulary));
  };
  offer();
  registration?.addEventListener('updatefound', () => registration.installing?.addEventListener('statechange', offer));
}
