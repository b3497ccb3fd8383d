/** What `offline.ts` needs at times only. */
export { takeShared } from './shared.ts';
export { offerVersion } from './version-offer.tsx';
