import type { HeardNews, ListenOrder } from '../listen/heard.ts';
import { startListening } from '../listen/listen.ts';
import { type ScanOrder, scanRequests } from '../scan/order.ts';
import { startScan } from '../scan/scan.ts';
import type { ScanNews } from '../scan/scan-news.ts';
import type { Hold, JobParts, RunningJob } from './job.ts';
import { type PollOrder, type PollSample, startPoll } from './poll.ts';
import { type ReadNews, type ReadOrder, readRequests, startReading } from './read.ts';
import { type SequenceNews, type SequenceOrder, sequenceRequests, startSequence } from './sequence.ts';
import { startTrials, type TrialNews, type TrialOrder } from './trials.ts';

/** What a session can do by itself. Another kind of job needs a member here and in what follows. */
export type JobOrder = PollOrder | ReadOrder | ScanOrder | ListenOrder | SequenceOrder | TrialOrder;
export type JobNews = PollSample | ReadNews | ScanNews | HeardNews | SequenceNews | TrialNews;

/** Every request that a job will send, for the guard to check before the job begins. */
export function requestsOf(order: JobOrder): readonly Uint8Array[] {
  switch (order.kind) {
    case 'poll':
      return order.requests;
    case 'read':
      return readRequests(order);
    case 'scan':
      return scanRequests(order);
    case 'listen':
      return [];
    case 'sequence':
      return sequenceRequests(order.sequence);
    case 'trials':
      return order.trials.map(({ request }) => request);
  }
}

/** Why nothing else may be sent while this job runs; `undefined` if other requests may be sent. */
export function holdOf(order: JobOrder): Hold | undefined {
  if (order.kind === 'listen') return 'listening';
  // Requests of others would be sent at the speed that is being tried.
  return order.kind === 'scan' && order.what === 'units' && order.lines.length > 0 ? 'scanning' : undefined;
}

export function startJob(order: JobOrder, parts: JobParts<JobNews>): RunningJob {
  switch (order.kind) {
    case 'poll':
      return startPoll(order, parts);
    case 'read':
      return startReading(order, parts);
    case 'scan':
      return startScan(order, parts);
    case 'listen':
      return startListening(parts);
    case 'sequence':
      return startSequence(order, parts);
    case 'trials':
      return startTrials(order, parts);
  }
}
