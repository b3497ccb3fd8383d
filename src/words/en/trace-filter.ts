import { describeFunction } from '../../modbus/index.ts';
import {
  type Completion,
  type FilterMistake,
  type FilterTermName,
  faultWords,
  type SeenFault,
} from '../../workbench/index.ts';
import { grouped } from './common.ts';
import { exceptionName } from './sent.ts';

const terms = {
  unit: 'unit',
  fc: 'function code',
  exception: 'exception code',
  value: 'a register or bit of the frame',
  slow: 'time to the reply, in milliseconds',
  addr: 'address as sent, or the number of a manual',
  conn: 'an end of the connection, or both',
  text: 'what the row says, or its bytes',
  from: 'at this time or later',
  to: 'at this time or before',
  cause: 'what explains the fault',
} satisfies Record<FilterTermName, string>;

/** What is wrong with a word of a filter, and what may stand there. */
function mistake(of: FilterMistake): string {
  switch (of.code) {
    case 'not-known':
      return of.meant === undefined
        ? `The filter knows no “${of.got}”. To look for a text, write it in quotes.`
        : `The filter knows no “${of.got}”. Do you mean “${of.meant}”?`;
    case 'value-missing':
      return `“${of.term}” needs a value: ${valueExamples[of.term]}. For the word itself, write it in quotes.`;
    case 'not-a-number':
      return `“${of.got}” is not a number.`;
    case 'out-of-range':
      return `${of.got} is not from ${of.least} to ${of.most}.`;
    case 'range-reversed':
      return `“${of.got}” begins with the larger number.`;
    case 'not-an-address':
      return `“${of.got}” is not an address: 107 or 0x6B as sent, or 40108 as in a manual.`;
    case 'tables-differ':
      return `“${of.got}” begins in one table and ends in another.`;
    case 'not-a-time':
      return `“${of.got}” is not a time: 10:31, 10:31:05, 2026-11-30T10:31, or seconds since the start.`;
    case 'not-a-cause':
      return `“${of.got}” is not a cause.`;
    case 'not-compared':
      return `“${of.term}” takes a colon: ${valueExamples[of.term]}.`;
    case 'quote-open':
      return 'The quotes are not closed.';
    case 'nothing-excluded':
      return 'Nothing follows that could be left out.';
  }
}

const valueExamples = {
  unit: 'unit:6',
  fc: 'fc:3,16',
  exception: 'exception:02',
  value: 'value>100',
  slow: 'slow>200',
  addr: 'addr:40001-40010',
  conn: 'conn:10.0.0.5:502',
  text: 'text:"30 Hz"',
  from: 'from:10:31',
  to: 'to:10:45',
  cause: 'cause:echo',
} satisfies Record<FilterTermName, string>;

type FaultNames = Readonly<Record<SeenFault, string>>;

/** What a completion of a filter means. */
function completion({ of, text, count }: Completion, faults: FaultNames): string {
  const often = count === undefined || count === 0 ? [] : [`${grouped(count)}×`];
  return [...completionName(of, text, faults), ...often].join(', ');
}

function completionName(of: Completion['of'], text: string, faults: FaultNames): readonly string[] {
  if (of.kind === 'fault') {
    const kind = faultWords.get(of.word);
    return [kind === undefined || kind === 'any' ? 'any fault' : faults[kind]];
  }
  if (of.kind === 'term') return [terms[of.term]];
  const value = Number(text.slice(text.indexOf(':') + 1));
  if (of.term === 'exception') return [exceptionName(value)];
  return of.term === 'fc' ? [describeFunction(value, 'request').name] : [];
}

/** What is said of the filter of a trace, with what went wrong with one frame. */
export const traceFilter = (faults: FaultNames) => ({
  filter: 'Filter',
  completions: 'What the filter may say',
  /** What a completion of the filter means, and how often that occurs. */
  completion: (of: Completion) => completion(of, faults),
  filterNames: { exception: exceptionName, fc: (of: number) => describeFunction(of, 'request').name },
  /** While the filter has a mistake: what the list shows. */
  keptFilter: (filter: string) =>
    filter === '' ? 'All rows are shown until the filter can be read.' : `Shown as before, by the filter ${filter}`,
  mistake,
  filterHint: 'unit:6 fc:3,16 exception:02',
});
