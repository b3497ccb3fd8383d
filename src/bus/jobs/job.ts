import type { Clock } from '../clock.ts';
import type { Link, LinkSettings } from '../link/link.ts';
import type { LogLine } from '../log/line.ts';
import type { BusClient } from '../transaction/bus-client.ts';

/** Why nothing else may be sent while a job needs the line to itself. */
export type Hold = 'scanning' | 'listening';

/** What a job gets to work with. */
export interface JobParts<News> {
  /** Another client after everything was stopped: a job with requests left asks for it again. */
  readonly client: BusClient;
  readonly clock: Clock;
  readonly tell: (news: News) => void;
  readonly link: Link;
  /** Opens the link again with other settings. Answers whether it is open then; it is not if somebody has closed it. */
  readonly reopen: (settings: LinkSettings) => Promise<boolean>;
  /** Writes a line into the log. Transactions are logged without this. */
  readonly log: (line: LogLine) => void;
}

/** A job while it runs. */
export interface RunningJob {
  /** Ends it after the reply to the last request, or its time-out. */
  stop(): void;
  /** Fulfilled when it has ended, by itself or because it was stopped. Never rejects. */
  readonly ended: Promise<void>;
}
