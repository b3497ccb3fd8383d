import { type Segment, splitStream } from '../../diagnosis/index.ts';
import { type Direction, joinBytes, MOST_ASCII, type SerialMode } from '../../modbus/index.ts';
import { Arrivals, MOST_ARRIVALS, MOST_PIECE, piecesOf } from '../transaction/arrivals.ts';

/** A piece of what was heard: a frame, or bytes that belong to none. */
export interface HeardPiece {
  readonly bytes: Uint8Array;
  /** When its first byte came. */
  readonly at: number;
  readonly frame?: {
    readonly transport: SerialMode;
    /** `undefined` if nothing tells. */
    readonly direction: Direction | undefined;
  };
}

const NOTHING = new Uint8Array(0);
/** Above this, there is no room for the next piece. */
const MOST_KEPT = MOST_ARRIVALS - MOST_PIECE;

/**
 * Splits what goes over a line while it comes. Each byte comes out once, in order. No more is kept than the longest frames
 * need.
 */
export class StreamSplitter {
  readonly #arrivals = new Arrivals();
  /** The frame that came out last, if it was a request: what follows is told by it. */
  #request: Uint8Array = NOTHING;

  /** Takes bytes; answers what has to come out so that they have room. */
  add(bytes: Uint8Array, at: number): readonly HeardPiece[] {
    const heard: HeardPiece[] = [];
    for (const piece of piecesOf(bytes)) {
      if (this.#arrivals.length > MOST_KEPT) heard.push(...this.split());
      this.#arrivals.add(piece, at);
    }
    return heard;
  }

  /** Gives out all that is sure: not the last frame, which tells what the one before it is, and nothing behind it. */
  split(): readonly HeardPiece[] {
    const segments = this.#segments();
    const last = segments.findLast(({ kind }) => kind === 'frame');
    const { length } = this.#arrivals;
    const keep = last !== undefined && length - last.from <= MOST_ASCII ? last.from : (last?.to ?? 0);
    // Noise without an end is not kept for a frame that might begin in it.
    const sure = Math.max(keep, length - MOST_ASCII);
    return this.#take(segments, sure);
  }

  /** Gives out everything: the line is silent. */
  end(): readonly HeardPiece[] {
    return this.#take(this.#segments(), this.#arrivals.length);
  }

  #segments(): readonly Segment[] {
    const { bytes } = this.#arrivals;
    const before = this.#request.length;
    if (before > 0 && bytes.length > 0) {
      const [first, ...others] = splitStream(joinBytes([this.#request, bytes]));
      if (first?.kind === 'frame' && first.to === before) {
        return others.map((segment) => ({ ...segment, from: segment.from - before, to: segment.to - before }));
      }
    }
    return splitStream(bytes);
  }

  /** Takes the segments up to a place out; one of noise may be cut there. */
  #take(segments: readonly Segment[], until: number): readonly HeardPiece[] {
    const heard: HeardPiece[] = [];
    for (const segment of segments) {
      if (segment.from >= until) break;
      const isFrame = segment.kind === 'frame' && segment.transport !== 'tcp';
      const length = (isFrame ? segment.to : Math.min(segment.to, until)) - segment.from;
      if (isFrame) {
        const { transport, direction } = segment;
        const { bytes, at } = this.#arrivals.take(length);
        heard.push({ bytes, at, frame: { transport: transport === 'ascii' ? 'ascii' : 'rtu', direction } });
        this.#request = direction === 'request' ? bytes : NOTHING;
        continue;
      }
      for (const { bytes, at } of this.#arrivals.takePieces(length)) heard.push({ bytes, at });
    }
    return heard;
  }
}
