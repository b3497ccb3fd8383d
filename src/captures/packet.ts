import type { Place } from '../trace/index.ts';

/** What is wrong with a file, or was left out of it. */
export interface CaptureProblem {
  readonly code: string;
  readonly place?: Place;
  readonly [data: string]: unknown;
}

/** What a reader of a file gives on: each packet's number (from 1, as tshark counts), link type, bytes, length on the wire, time. */
export interface PacketSink {
  /** `time` is in microseconds since 1970; NaN if the file does not tell it. */
  packet(number: number, link: number, from: number, to: number, wire: number, time: number): void;
  problem(problem: CaptureProblem): void;
}
