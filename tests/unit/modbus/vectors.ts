import { readFileSync } from 'node:fs';
import type { Direction, Transport } from '../../../src/modbus/index.ts';

/** A valid frame of `tests/vectors/frames.json`. */
export interface VectorFrame {
  readonly id: string;
  readonly transport: Transport;
  readonly direction: Direction;
  readonly hex: string;
  readonly unitId?: number;
  readonly transactionId?: number;
  readonly functionCode: number;
  readonly fields: Readonly<Record<string, unknown>>;
  readonly derived?: Readonly<Record<string, unknown>>;
  /** The request it answers, in hexadecimal pairs. */
  readonly request?: string;
}

/** A frame of `tests/vectors/broken-frames.json`. */
export interface BrokenFrame {
  readonly id: string;
  readonly transport: Transport;
  readonly directions: readonly Direction[];
  readonly hex: string;
  readonly wrong: readonly string[];
}

/** A frame that somebody asked about, of `tests/vectors/user-frames.json`. */
export interface UserFrame {
  readonly id: string;
  /** `data`: no frame, but the bytes of registers. */
  readonly transport: Transport | 'data';
  readonly hex: string;
  readonly finding: string;
  /** The request it answers, in hexadecimal pairs. */
  readonly answering?: string;
}

const load = (file: string): unknown =>
  JSON.parse(readFileSync(new URL(`../../vectors/${file}`, import.meta.url), 'utf8'));

export const frames = load('frames.json') as readonly VectorFrame[];
export const brokenFrames = load('broken-frames.json') as readonly BrokenFrame[];
export const userFrames = load('user-frames.json') as readonly UserFrame[];
