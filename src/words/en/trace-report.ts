import type { ReportWords } from '../../workbench/index.ts';
import { plural } from './common.ts';
import { finding } from './findings.ts';
import { trace } from './trace.ts';

/** What a report of a trace says. */
export const traceReport: ReportWords = {
  title: 'Modbus log',
  size: trace.size,
  faultCount: trace.faultCount,
  noFault: trace.noFaults,
  units: trace.units,
  replyTime: trace.replyTime,
  causes: trace.causes,
  cause: (of) => `${trace.cause(of)} (${trace.evidence(of)})`,
  faults: 'Faults',
  faultColumns: ['frame', 'time', 'unit', 'what it says', 'bytes'],
  sentence: trace.sentence,
  finding: (of) => finding(of).title,
  filtered: (frames, filter) =>
    `Only the faults of ${plural(frames, 'frame')} are shown, ${filter === undefined ? 'which a filter keeps' : `which the filter ${filter} keeps`}.`,
  more: (count) => `${plural(count, 'more fault')} ${count === 1 ? 'is' : 'are'} not shown.`,
  statistics: 'By unit',
  unitColumns: ['unit', 'exchanges', 'replies', 'faults', 'reply (median)', 'reply (95 %)', 'reply (maximum)'],
  duration: trace.duration,
};
