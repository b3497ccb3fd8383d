export { type PrintedClock, printedTime } from './clock.ts';
export { type OtherFile, otherFile } from './other-file.ts';
export type { CaptureProblem } from './packet.ts';
export { type Capture, isBinary, type Records, readCapture } from './read-capture.ts';
export type { UnframedPiece } from './text.ts';
export { readTraceJson, traceJsonParts, writeTraceJson } from './trace-json.ts';
export { pcapngBlocks, type WrittenRecord, writePcapng } from './write-pcapng.ts';
