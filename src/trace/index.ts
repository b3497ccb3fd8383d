export { type Exchange, type Fault, type FaultKind, faultKinds } from './fault.ts';
export { bytesColumn, Column, countsColumn, indexColumn, timesColumn } from './numbers.ts';
export type { CaptureRecord, Place, TraceInput } from './record.ts';
export { Trace, type TraceOptions, type TraceSummary, traceOf } from './trace.ts';
