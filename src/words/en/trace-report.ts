import type { ReportWords, SaidCause } from '../../workbench/index.ts';
import { plural } from './common.ts';
import { findings } from './findings.ts';

/** What the Log view says, and a report too. */
type LogWords = Pick<
  ReportWords,
  'size' | 'faultCount' | 'units' | 'replyTime' | 'causes' | 'sentence' | 'duration'
> & {
  readonly noFaults: string;
  readonly cause: (of: SaidCause) => string;
  readonly evidence: (of: SaidCause) => string;
};

/** What a report of a trace says. */
export const reportWords = (log: LogWords): ReportWords => ({
  ...log,
  title: 'Modbus log',
  noFault: log.noFaults,
  cause: (of) => `${log.cause(of)} (${log.evidence(of)})`,
  faults: 'Faults',
  faultColumns: ['frame', 'time', 'unit', 'what it says', 'bytes'],
  finding: (of) => findings(of).title,
  filtered: (frames, filter) =>
    `Only the faults of ${plural(frames, 'frame')} are shown, ${filter === undefined ? 'which a filter keeps' : `which the filter ${filter} keeps`}.`,
  more: (count) => `${plural(count, 'more fault')} ${count === 1 ? 'is' : 'are'} not shown.`,
  statistics: 'By unit',
  unitColumns: ['unit', 'exchanges', 'replies', 'faults', 'reply (median)', 'reply (95 %)', 'reply (maximum)'],
});
