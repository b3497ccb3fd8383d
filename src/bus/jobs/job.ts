import type { Clock } from '../clock.ts';
import type { Link, LinkSettings } from '../link/link.ts';
import type { LogLine } from '../log/line.ts';
import type { BusClient } from '../transaction/bus-client.ts';

/** Why nothing else may be sent while a job has the line to itself. */
export type Hold = 'scanning' | 'listening';

/** What a job has to work with. */
export interface JobParts<News> {
  /** Another one after all was stopped: a job that has something left to send then asks for it again. */
  readonly client: BusClient;
  readonly clock: Clock;
  readonly tell: (news: News) => void;
  readonly link: Link;
  /** Opens the link anew with other settings; whether it is open then. It is not where somebody has closed it. */
  readonly reopen: (settings: LinkSettings) => Promise<boolean>;
  /** Writes a line into the log; answers its number. Transactions are in it without that. */
  readonly log: (line: Omit<LogLine, 'number'>) => number;
}

/** Something that sends on its own for a while. */
export interface RunningJob {
  /** Ends it soon: what has been sent is still waited for. */
  stop(): void;
  /** Fulfilled when it has ended, of itself or stopped. Never rejects. */
  readonly ended: Promise<void>;
}
