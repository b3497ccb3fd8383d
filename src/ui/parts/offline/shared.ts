import { openFile } from '../pasted.ts';

/** Where `scripts/offline/worker.js` puts what another program has shared with the page. */
const PLACE = 'framewright-shared';

/** Reads what was shared, once: a short text as if it were pasted, any other file in the Log view. */
export async function takeShared(): Promise<void> {
  history.replaceState(history.state, '', location.pathname + location.hash);
  const cache = await caches.open(PLACE);
  const [request] = await cache.keys();
  const shared = request && (await cache.match(request));
  await caches.delete(PLACE);
  if (shared) await openFile(new File([await shared.blob()], decodeURIComponent(shared.headers.get('name') ?? '')));
}
