import { closeSync, openSync, writeSync } from 'node:fs';
import { ReadStream } from 'node:tty';

/** What is sent for a request: the right reply so many milliseconds later, and its copies. */
export type Manner = (number: number) => readonly number[];

/** A device at the far end of a cable, which takes its time: register n of unit 1 holds 1000 + n. */
export class LatePeer {
  /** Requests that have come. */
  requests = 0;
  readonly #stream: ReadStream;
  readonly #out: number;

  constructor(tty: string, manner: Manner) {
    this.#out = openSync(tty, 'r+');
    this.#stream = new ReadStream(openSync(tty, 'r+'));
    let request = Buffer.alloc(0);
    this.#stream.on('data', (bytes: Buffer) => {
      request = Buffer.concat([request, bytes]);
      // All requests of these tests are reads: unit, function, address, quantity, CRC.
      for (; request.length >= 8; request = request.subarray(8)) {
        const reply = replyTo(request.readUInt16BE(2), request.readUInt16BE(4));
        this.#answer(reply, manner(this.requests));
        this.requests += 1;
      }
    });
  }

  /** Copies come in the turn of the reply: by timers of their own, a busy machine would send them into the next request. */
  #answer(reply: Buffer, [first = 0, ...copies]: readonly number[]): void {
    setTimeout(() => {
      const asked = performance.now() - first;
      this.#send(reply);
      for (const after of copies) {
        while (performance.now() - asked < after);
        this.#send(reply);
      }
    }, first);
  }

  #send(reply: Buffer): void {
    if (!this.#stream.destroyed) writeSync(this.#out, reply);
  }

  stop(): void {
    this.#stream.destroy();
    closeSync(this.#out);
  }
}

function replyTo(address: number, quantity: number): Buffer {
  const values = Array.from({ length: quantity }, (_, at) => 1000 + address + at);
  const bytes = [1, 3, 2 * quantity, ...values.flatMap((value) => [value >> 8, value & 0xff])];
  let crc = 0xffff;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >>> 1) ^ 0xa001 : crc >>> 1;
  }
  return Buffer.from([...bytes, crc & 0xff, crc >> 8]);
}
