import { type SerialMode, sameBytes } from '../../modbus/index.ts';
import { Arrivals } from './arrivals.ts';
import { anyFrame, fits } from './find-frame.ts';
import type { Stray } from './result.ts';

/** A request that was given up, whose reply may still come. */
interface Unanswered {
  readonly transport: SerialMode;
  readonly request: Uint8Array;
  readonly until: number;
}

const MOST_UNANSWERED = 8;
/** No device is later than this, in milliseconds. */
const LATEST = 30_000;

/** What one transaction leaves for the next, of an open line. Times are the clock's. */
export class LineMemory {
  /** What has come and belongs to nothing yet. */
  readonly arrivals = new Arrivals();
  /** When the last byte came, and when the line was, or will be, free after the last sending. */
  heardAt = Number.NEGATIVE_INFINITY;
  freeAt = Number.NEGATIVE_INFINITY;
  /** Whether the adapter gives back what is sent, once that is known. */
  echoes: boolean | undefined = undefined;
  /** The last request, where its only answer may have been its echo. */
  perhapsEcho: Uint8Array | undefined = undefined;
  /** A reply has come sooner than the request could be sent: this is no line that takes its time. */
  unpaced = false;
  #unanswered: Unanswered[] = [];

  giveUp(transport: SerialMode, request: Uint8Array, now: number): void {
    const still = this.#unanswered.filter(({ until }) => until > now).slice(1 - MOST_UNANSWERED);
    this.#unanswered = [...still, { transport, request, until: now + LATEST }];
  }

  /** The request given up before that this frame answers, if one is. */
  wasAsked(frame: Uint8Array, now: number): Unanswered | undefined {
    return this.#unanswered.find((one) => one.until > now && fits(frame, one));
  }

  /** Whether what has come may go on: it is not whole frames and nothing else. */
  goesOn(transport: SerialMode): boolean {
    let { bytes } = this.arrivals;
    while (bytes.length > 0) {
      const frame = anyFrame(bytes, transport);
      if (frame === undefined || frame.from > 0) return true;
      bytes = bytes.subarray(frame.to);
    }
    return false;
  }

  /** Takes all that has come and that nobody waits for. */
  drain(transport: SerialMode): Stray[] {
    const { arrivals } = this;
    const strays: Stray[] = [];
    const take = (what: 'frame' | 'noise', length: number) => {
      if (length === 0) return;
      const at = arrivals.at(0);
      const bytes = arrivals.take(length);
      strays.push(what === 'noise' ? { what, bytes, at } : this.strayFrame(bytes, at));
    };
    while (arrivals.length > 0) {
      const frame = anyFrame(arrivals.bytes, transport);
      take('noise', frame?.from ?? arrivals.length);
      if (frame !== undefined) take('frame', frame.to - frame.from);
    }
    return strays;
  }

  /** What a frame is that nobody waits for. */
  strayFrame(bytes: Uint8Array, at: number): Stray {
    if (this.perhapsEcho !== undefined && sameBytes(bytes, this.perhapsEcho)) {
      this.perhapsEcho = undefined;
      // So the first one was the echo.
      this.echoes = true;
    }
    const asked = this.wasAsked(bytes, at);
    if (asked === undefined) return { what: 'other', bytes, at };
    this.#unanswered = this.#unanswered.filter((one) => one !== asked);
    return { what: 'late', bytes, at, answers: asked.request };
  }
}
