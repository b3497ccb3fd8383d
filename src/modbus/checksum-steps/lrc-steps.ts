/** How an LRC is computed (SL 2.5.2.2): the bytes are added, and the sum is negated. */
export class LrcSteps {
  readonly bytes: Uint8Array;
  /** The sum before each byte, and after the last, modulo 256. */
  readonly sums: Uint8Array;

  constructor(bytes: Uint8Array) {
    this.bytes = bytes;
    this.sums = new Uint8Array(bytes.length + 1);
    for (let at = 0; at < bytes.length; at++) this.sums[at + 1] = (this.sums[at] as number) + (bytes[at] as number);
  }

  /** The sum of all bytes, modulo 256. */
  get sum(): number {
    return this.sums[this.bytes.length] as number;
  }

  /** The sum with all its bits turned over. */
  get inverted(): number {
    return ~this.sum & 0xff;
  }

  /** The LRC: one more than `inverted`, so that the LRC and the sum add up to 0. */
  get value(): number {
    return (this.inverted + 1) & 0xff;
  }
}
