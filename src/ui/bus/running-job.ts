import type { JobNews, JobOrder, Refusal } from '../../bus/index.ts';
import { bus } from './bus.ts';

/** Why a job is over, or was not begun. */
export type JobEnd =
  | { readonly kind: 'stopped' | 'lost' | 'disconnected' | 'declined' }
  | { readonly kind: 'refused'; readonly why: Refusal };

interface JobFollower {
  news(news: readonly JobNews[]): void;
  ended(end: JobEnd): void;
}

/** Begins a job; answers how to stop it. `stopped` is also the end of one that ended of itself. */
export function runningJob(order: JobOrder, follower: JobFollower): () => void {
  let stopping = false;
  const id = bus.startJob(order, {
    news: (news) => follower.news(news),
    ended(why) {
      const { link, refused } = bus.state;
      if (why === 'declined') follower.ended({ kind: 'declined' });
      else if (why === 'refused') follower.ended({ kind: 'refused', why: refused ?? 'busy' });
      else if (link.kind === 'lost') follower.ended({ kind: 'lost' });
      else follower.ended({ kind: link.kind === 'open' || stopping ? 'stopped' : 'disconnected' });
    },
  });
  return () => {
    stopping = true;
    bus.stopJob(id);
  };
}
