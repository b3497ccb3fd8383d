import { CrcWindows } from './crc-windows.ts';
import { demandWhole } from './demand.ts';
import { REQUEST, RESPONSE, type Side } from './pdu-walk.ts';
import type { Direction } from './reading.ts';
import { MOST_RTU } from './rtu.ts';
import { LEAST_RTU, rtuPduEnd } from './rtu-end.ts';
import { CRC } from './serial.ts';

/** All exceptions have the same length; half of all bytes are the function code of one. */
const FIRST_EXCEPTION = 0x80;
const EXCEPTION = 1 + (RESPONSE.widths[FIRST_EXCEPTION] as number) + CRC.width;

/** By function code, 1 if it is not an exception's and a byte may say where its frames end. */
const TOLD = Uint8Array.from(REQUEST.open, (open, code) =>
  code < FIRST_EXCEPTION && (open === 0 || RESPONSE.open[code] === 0) ? 1 : 0,
);

/**
 * Looks for RTU frames at every place of a stream: `framesAt` without a judgement of what their fields hold, at a fraction
 * of its time. Every place takes about the same short time. All throw a `RangeError` for a place that is not a whole number
 * from 0.
 */
export class RtuScan {
  readonly #bytes: Uint8Array;
  /** Made when places are looked through: where one frame follows another there is nothing to look through. */
  #windows: CrcWindows | undefined = undefined;

  constructor(bytes: Uint8Array) {
    this.#bytes = bytes;
  }

  /** The first place from `from` on where an RTU frame may begin; the number of bytes if there is no such place. */
  next(from: number): number {
    demandPlace(from);
    const bytes = this.#bytes;
    if (this.#begins(from)) return from;
    const windows = this.#windows ?? new CrcWindows(bytes);
    this.#windows = windows;
    const { registers } = windows;
    const move = windows.mover(EXCEPTION);
    const { length } = bytes;
    // Up to here even the longest frame ends before the bytes do: no frame is closed by the end of the bytes.
    const far = length - MOST_RTU;
    let at = from;
    for (; at < far; at++) {
      const functionCode = bytes[at + 1] as number;
      if (TOLD[functionCode] === 1) {
        if (this.#begins(at)) return at;
      } else {
        const before = (registers[at] as number) ^ 0xffff;
        const after = (move[before & 0xff] as number) ^ (move[256 + (before >>> 8)] as number);
        if (after === registers[at + EXCEPTION] && this.#begins(at)) return at;
      }
    }
    for (; at + LEAST_RTU <= length; at++) if (this.#begins(at)) return at;
    return length;
  }

  /**
   * Where the RTU frame of this direction ends that begins at `at`, by its fields and its CRC; 0 if there is no such frame.
   * If two ends are possible, it is the first.
   */
  endAt(at: number, direction: Direction): number {
    demandPlace(at);
    return this.#end(at, direction === 'request' ? REQUEST : RESPONSE);
  }

  /** Whether an RTU frame may begin at `at`. */
  begins(at: number): boolean {
    demandPlace(at);
    return this.#begins(at);
  }

  #begins(at: number): boolean {
    return this.#end(at, REQUEST) > 0 || this.#end(at, RESPONSE) > 0;
  }

  #end(at: number, side: Side): number {
    const { length } = this.#bytes;
    if (at + LEAST_RTU > length) return 0;
    const pdu = rtuPduEnd(side, this.#bytes, at, length, 0, this.#windows);
    return pdu > 0 ? pdu + CRC.width : 0;
  }
}

/** Asked at every place of a stream, so that the usual answer is one comparison. */
function demandPlace(at: number): void {
  if (at >>> 0 !== at) demandWhole('place', at, 0, Number.MAX_SAFE_INTEGER);
}
