export { type CauseCode, causesOf, isCauseCode, type TraceCause } from './causes.ts';
export type { Subject } from './exchanges.ts';
export { type Exchange, type Fault, type FaultKind, faultKinds } from './fault.ts';
export {
  type Beside,
  besides,
  type Known,
  knownOf,
  type Outcome,
  outcomes,
  type Reason,
  readKnown,
  reasons,
} from './known.ts';
export {
  type KnownTable,
  type KnownValue,
  KnownValues,
  type ValueList,
  valuesRead,
  valuesWritten,
} from './known-values.ts';
export { Column, countsColumn, indexColumn, timesColumn } from './numbers.ts';
export type { CaptureRecord, Place, TraceInput } from './record.ts';
export type { Spread } from './spread.ts';
export { Statistics as TraceStatistics, type Tallied, type Tally, tallied } from './statistics.ts';
export { isAdu } from './told.ts';
export { type Spoken, Trace, type TraceOptions, type TraceSummary, traceOf } from './trace.ts';
