/**
 * The library under the page: the pure layers, without a DOM, a clock or a network.
 * @module
 */
export { type Capture, type CaptureProblem, type Records, readCapture } from './captures/index.ts';
export * from './codegen/index.ts';
export * from './devices/index.ts';
export * from './diagnosis/index.ts';
export * from './modbus/index.ts';
export * from './notation/index.ts';
export type { Sequence, Step, Until } from './sequences/index.ts';
export {
  type CaptureRecord,
  type Exchange,
  type Fault as TraceFault,
  type FaultKind,
  type Place,
  Trace,
  type TraceInput,
  type TraceOptions,
  type TraceSummary,
  traceOf,
} from './trace/index.ts';
