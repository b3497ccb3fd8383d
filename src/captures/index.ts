export type { CaptureProblem } from './packet.ts';
export { type Capture, type Records, readCapture } from './read-capture.ts';
