export type { DiagnoseContext } from './case.ts';
export { diagnose } from './diagnose.ts';
export type { Confidence, Finding, FindingCode, FindingData } from './finding.ts';
export { type Segment, splitStream } from './split-stream.ts';
