import { type Direction, type FrameAt, framesAt } from '../modbus/index.ts';
import { type Chosen, chooseFrames } from './choose-frames.ts';
import { fillGaps } from './open-frames.ts';
import { tellDirections } from './tell-directions.ts';

/** A piece of a stream: a frame, or bytes that belong to none. */
export type Segment =
  | {
      readonly kind: 'frame';
      readonly transport: FrameAt['transport'];
      /** `undefined` where the frame can be either, and what stands around it does not tell. */
      readonly direction: Direction | undefined;
      readonly from: number;
      readonly to: number;
      /** No field breaks a rule of its own. */
      readonly legal: boolean;
    }
  | { readonly kind: 'gap'; readonly from: number; readonly to: number };

const TRANSPORTS = ['rtu', 'ascii', 'tcp'] as const;

/**
 * Splits the bytes that went over a line, in both directions, without times and with bytes lost or damaged, into frames
 * and the gaps between them. The segments cover every byte exactly once, in order, and no two gaps adjoin. All frames
 * have one transport: the one in which they cover the most bytes. Never throws; takes time linear in the number of bytes.
 */
export function splitStream(bytes: Uint8Array): readonly Segment[] {
  let best: Chosen[] = [];
  let most = 0;
  for (const transport of TRANSPORTS) {
    // What covers most of the bytes cannot be outdone.
    if (2 * most > bytes.length) break;
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

function candidates(bytes: Uint8Array, transport: FrameAt['transport']): FrameAt[] {
  const found: FrameAt[] = [];
  for (let at = 0; at < bytes.length; at++) {
    const here = framesAt(bytes, at, bytes.length, transport);
    for (let i = 0; i < here.length; i++) found.push(here[i] as FrameAt);
  }
  return found;
}

function segments(bytes: Uint8Array, frames: readonly Chosen[]): Segment[] {
  const directions = tellDirections(bytes, frames);
  const found: Segment[] = [];
  let at = 0;
  frames.forEach(({ from, to, readings: [first] }, i) => {
    if (at < from) found.push({ kind: 'gap', from: at, to: from });
    const { transport, legal } = first;
    found.push({ kind: 'frame', transport, direction: directions[i], from, to, legal });
    at = to;
  });
  if (at < bytes.length) found.push({ kind: 'gap', from: at, to: bytes.length });
  return found;
}
