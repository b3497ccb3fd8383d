import type { JobParts, RunningJob } from './job.ts';
import { type PollOrder, type PollSample, startPoll } from './poll.ts';

/** What a session can do on its own. A further kind of job is a member here and in the two below. */
export type JobOrder = PollOrder;
export type JobNews = PollSample;

/** All that a job will send, for the guard to look at before it begins. */
export function requestsOf(order: JobOrder): readonly Uint8Array[] {
  switch (order.kind) {
    case 'poll':
      return order.requests;
  }
}

export function startJob(order: JobOrder, parts: JobParts<JobNews>): RunningJob {
  switch (order.kind) {
    case 'poll':
      return startPoll(order, parts);
  }
}
