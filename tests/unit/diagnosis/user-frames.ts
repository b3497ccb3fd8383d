import { readFileSync } from 'node:fs';

/** A frame that somebody asked about, of `tests/vectors/user-frames.json`. */
export interface UserFrame {
  readonly id: string;
  readonly hex: string;
}

export const userFrames: readonly UserFrame[] = JSON.parse(
  readFileSync(new URL('../../vectors/user-frames.json', import.meta.url), 'utf8'),
);
