import type { ExpectedHow, PairReason } from '../../workbench/index.ts';
import { bytesOf } from './common.ts';

/** Why a request and a reply belong together. */
const pairs: Readonly<Record<PairReason, string>> = {
  transaction: 'Transaction, unit, function and length agree.',
  exception: 'It refuses the function of the request.',
  'same-content': 'It repeats the content of the request.',
  'unit-function-length': 'Unit, function and length agree.',
  differs: 'It was said to answer this request, and does not: see its errors.',
};

const expected: Readonly<Record<ExpectedHow, (size: number, values: number) => string>> = {
  exact: () => 'Every byte follows from the request.',
  layout: (size, values) =>
    `${bytesOf(size)}, of which ${bytesOf(values)} hold the values that only the device knows, here as 0.`,
  open: () => 'Only the device knows how long it is and what it holds. Its layout, with example values:',
};

/** The other frame of an exchange. */
export const reply = {
  pairs,
  expected,
  silence: {
    broadcast: 'None: no device answers a broadcast.',
    silent: 'None: after this sub-function the device only listens, and does not answer.',
  },
  refused:
    'If the device refuses, three things change: the function code has its top bit set, one byte says why, and nothing else follows.',
  use: 'Build this reply',
  useException: 'Build the exception',
  noReply: 'Correct the request to see its reply.',
  noRequest: 'This frame is a reply. The request that it answers is not known; it can be put into the form.',
  /** Before the request that a reply answers, and before the reply that came to a request. */
  request: 'This frame answers the request:',
  reply: 'The reply that came:',
  toRequest: 'Go to the request',
  toReply: 'Go to the reply',
};

export type ReplyWords = typeof reply;
