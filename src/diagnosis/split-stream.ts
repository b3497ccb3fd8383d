import type { Direction, FrameAt } from '../modbus/index.ts';
import { type Candidate, candidates } from './candidate.ts';
import { chooseFrames } from './choose-frames.ts';
import { fillGaps } from './open-frames.ts';
import { tellDirections } from './tell-directions.ts';

/** A piece of a stream: a frame, or bytes that belong to none. */
export type Segment =
  | {
      readonly kind: 'frame';
      readonly transport: FrameAt['transport'];
      /** `undefined` if the frame can be either, and its neighbours do not tell. */
      readonly direction: Direction | undefined;
      readonly from: number;
      readonly to: number;
    }
  | { readonly kind: 'gap'; readonly from: number; readonly to: number };

const TRANSPORTS = ['rtu', 'ascii', 'tcp'] as const;

/**
 * Splits the bytes that went over a line, in both directions, without times and with bytes lost or damaged, into frames
 * and the gaps between them. The segments cover every byte exactly once, in order, and no two gaps adjoin. All frames
 * have one transport: the one in which they cover the most bytes. Never throws; takes time linear in the number of bytes.
 */
export function splitStream(bytes: Uint8Array): readonly Segment[] {
  let best: Candidate[] = [];
  let most = 0;
  for (const transport of TRANSPORTS) {
    // This much cannot be chance: the other transports need not be tried.
    if (4 * most > bytes.length) break;
    const chosen = chooseFrames(bytes, candidates(bytes, transport));
    const frames = transport === 'rtu' ? fillGaps(bytes, chosen) : chosen;
    const covered = frames.reduce((sum, { from, to }) => sum + to - from, 0);
    if (covered > most) {
      best = frames;
      most = covered;
    }
  }
  return segments(bytes, best);
}

function segments(bytes: Uint8Array, frames: readonly Candidate[]): Segment[] {
  const directions = tellDirections(bytes, frames);
  const found: Segment[] = [];
  let at = 0;
  for (let i = 0; i < frames.length; i++) {
    const { transport, from, to } = frames[i] as Candidate;
    if (at < from) found.push({ kind: 'gap', from: at, to: from });
    found.push({ kind: 'frame', transport, direction: directions[i], from, to });
    at = to;
  }
  if (at < bytes.length) found.push({ kind: 'gap', from: at, to: bytes.length });
  return found;
}
