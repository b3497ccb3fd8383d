import type { NamedValue } from '../../devices/index.ts';
import { describeFunction } from '../../modbus/index.ts';
import type { FaultKind, KnownTable, Tallied, Tally } from '../../trace/index.ts';
import { faultKinds } from '../../trace/index.ts';
import type { KnownColumn, SeenFault, TallyColumn, TimelineBin } from '../../workbench/index.ts';
import { code, fields, grouped, plural } from './common.ts';
import { devices } from './devices.ts';
import { exceptionName } from './sent.ts';

const columns = {
  unit: 'unit',
  functionCode: 'function',
  address: 'first address',
  quantity: 'quantity',
  connection: 'connection',
  exchanges: 'exchanges',
  replies: 'replies',
  faults: 'faults',
  minimum: 'fastest reply',
  median: 'median',
  p95: '95 % within',
  maximum: 'slowest reply',
  interval: 'asked every',
} satisfies Record<TallyColumn, string>;

const knownColumns = {
  unit: 'unit',
  table: 'table',
  address: 'address',
  number: 'number',
  name: 'name',
  value: 'value',
  means: 'means',
  when: 'last seen',
  reads: 'reads',
  writes: 'writes',
  changes: 'changes',
} satisfies Record<KnownColumn, string>;

const functionName = (of: number) => `${code(of)} ${describeFunction(of, 'request').name}`;

interface FaultWords {
  readonly count: (kind: SeenFault, count: number) => string;
  readonly duration: (time: number) => string;
}

/** What the tabs beside the list of a trace say, with words of the list. */
export const traceTabs = ({ count, duration }: FaultWords) => ({
  label: 'The log',
  names: { rows: 'Frames', timeline: 'Timeline', statistics: 'Statistics', values: 'Values' },
  counting: 'Counting…',
  ofWholeLog: 'Counted in the whole log, whatever the filter.',
  nothing: 'Nothing matches the filter.',
  more: (some: number) => `Show ${grouped(some)} more`,
  timeline: {
    label: 'Reply times and faults over time',
    noTimes: 'This log has no times.',
    untimed: (some: number) => `${plural(some, 'exchange')} without a time ${some === 1 ? 'is' : 'are'} left out.`,
    after: 'time to the reply',
    legend: (kind: SeenFault, some: number) => count(kind, some),
    hint: 'Drag to show a part of the time, click to go to the row. With keys: arrows move, Shift and arrows select, Enter goes there.',
    showAll: 'Show all of the time',
    asTable: 'As a table',
    columns: {
      time: 'from',
      exchanges: 'exchanges',
      minimum: 'fastest reply',
      maximum: 'slowest reply',
      faults: 'faults',
    },
    /** What stands in a column of the picture; `when` is the time of its first exchange. */
    bin: (when: string, { exchanges, minimum, maximum, faults }: TimelineBin) =>
      [
        `${when}: ${plural(exchanges, 'exchange')}`,
        ...(minimum === undefined || maximum === undefined
          ? []
          : [
              `reply after ${minimum === maximum ? duration(minimum) : `${duration(minimum)} to ${duration(maximum)}`}`,
            ]),
        ...faults.map(({ kind, count: some }) => count(kind, some)),
      ].join(', '),
    faults: ({ faults }: TimelineBin) => faults.map(({ kind, count: some }) => count(kind, some)).join(', '),
    goTo: (when: string) => `${when}: go to the row`,
    selected: (from: string, to: string) => `Selected from ${from} to ${to}.`,
  },
  statistics: {
    by: 'Counted by',
    byNames: {
      unit: 'unit',
      function: 'function',
      address: 'address',
      connection: 'connection',
      poll: 'same request',
    } satisfies Record<Tallied, string>,
    columns,
    functionName,
    fault: (kind: FaultKind) => count(kind, 2).replace(/^2 /, ''),
    exceptions: 'exceptions',
    exception: (of: number, some: number) => `${exceptionName(of)} × ${grouped(some)}`,
    noConnection: 'not known',
    number: grouped,
    /** `3 exceptions (exception 02, Illegal data address × 3), 1 wrong CRC`. */
    faults: ({ faults, exceptions }: Tally) =>
      faultKinds
        .filter((kind) => faults[kind] > 0)
        .map((kind) => {
          const named = [...exceptions].map(([of, some]) =>
            exceptions.size === 1 ? exceptionName(of) : `${exceptionName(of)} × ${grouped(some)}`,
          );
          return `${count(kind, faults[kind])}${kind === 'exception' && named.length > 0 ? ` (${named.join('; ')})` : ''}`;
        })
        .join(', '),
    showRows: (what: string) => `${what}: show the rows`,
    copy: 'Copy',
    as: 'as',
    formats: { csv: 'CSV', tsv: 'cells of a spreadsheet', markdown: 'Markdown' },
    firstOf: (some: number, all: number) => `These are the first ${grouped(some)} of ${grouped(all)} in this order.`,
    copied: 'Copied.',
    refused: (text: string) => `The browser does not allow copying. Copy this: ${text}`,
  },
  values: {
    columns: knownColumns,
    table: (table: KnownTable) => fields.tables[table].one,
    inUnits: (value: NamedValue) => devices.inUnits(value),
    unit: 'Unit',
    allUnits: 'all',
    unitName: (unit: number) => `unit ${unit}`,
    changed: 'only what changed',
    count: (some: number) => plural(some, 'value'),
    bit: (value: number) => (value ? 'ON' : 'OFF'),
    reads: (some: number) => plural(some, 'read'),
    writes: (some: number) => plural(some, 'write'),
    changes: (some: number) => plural(some, 'change'),
    none: 'No reply in this log shows a register or a bit.',
    noneChanged: 'No value changed.',
    hint: 'A click, or Enter, shows the rows of a value.',
    save: 'Save as CSV',
    makeDevice: (unit: number | undefined) => (unit === undefined ? 'Make a device' : `Make a device of unit ${unit}`),
    deviceMade: (name: string) => `“${name}” is the device now.`,
    editDevice: 'Edit or save it',
    chooseUnit: 'Choose a unit first: a device is made of one unit.',
    deviceName: (unit: number, file: string | undefined) => `Unit ${unit}${file === undefined ? '' : ` of ${file}`}`,
    deviceSource: (file: string | undefined) => `What was seen in ${file ?? 'a pasted log'}`,
  },
});
