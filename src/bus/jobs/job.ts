import type { Clock } from '../clock.ts';
import type { BusClient } from '../transaction/bus-client.ts';

/** What a job has to work with. */
export interface JobParts<News> {
  readonly client: BusClient;
  readonly clock: Clock;
  readonly tell: (news: News) => void;
}

/** Something that sends on its own for a while. */
export interface RunningJob {
  /** Ends it soon: what has been sent is still waited for. */
  stop(): void;
  /** Fulfilled when it has ended, of itself or stopped. Never rejects. */
  readonly ended: Promise<void>;
}
