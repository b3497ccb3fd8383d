import { joinBytes, MOST_RTU } from '../modbus/index.ts';
import { type Carriage, carriageOf, frameEnd, isMbapAt, MORE, NO_FRAME, nextFrame, sureEnd } from './adus.ts';
import type { Conversation, Found } from './found.ts';
import type { CaptureProblem } from './packet.ts';

/** Packets with data, of which a stream on another port must show that they are Modbus. */
const TRIES = 4;
const MODBUS_PORT = 502;
/** Modbus/TCP Security (its specification, 8.4), and how a record of TLS 1.x begins: handshake, version 3. */
const SECURE_PORT = 802;
const TLS = [0x16, 0x03] as const;
/** A hole that is not filled after so many later segments, or bytes, is lost. */
const MOST_WAITING = 256;
const SYN = 0x02;
const RST = 0x04;
const ACK = 0x10;

interface Segment {
  readonly seq: number;
  readonly bytes: Uint8Array;
  readonly from: number;
  readonly to: number;
  /** Bytes that the segment had on the wire and the file has not. */
  readonly missing: number;
  readonly packet: number;
  readonly time: number;
}

/** Distance of two sequence numbers, with their wrap-around (RFC 9293, 3.4). */
const distance = (one: number, other: number) => (one - other) | 0;

/** What one end of a connection sends. */
class Half {
  /** The next sequence number; `undefined` before the first segment. */
  next: number | undefined;
  waiting: Segment[] = [];
  /** The beginning of a frame whose end is still to come, and its packets. */
  rest: Uint8Array | undefined;
  restPackets: number[] = [];
  restTime = Number.NaN;
  /** Where a frame begins is not known: after a hole, or in a stream that was joined in its middle. */
  lost = true;
  /** No frame has been found since a hole: what looks like one must be legal, and more must speak for it. */
  doubted = false;
}

/** One TCP connection, or what two ports say to each other by UDP. */
export class Stream implements Conversation {
  readonly ends: readonly [string, string];
  server: number;
  readonly #halves = [new Half(), new Half()] as const;
  readonly #found: Found;
  readonly #problem: (problem: CaptureProblem) => void;
  readonly #known: boolean;
  readonly #maySecure: boolean;
  #carriage: Carriage | undefined;
  #tries = 0;
  #isSecure = false;

  constructor(
    ends: readonly [string, string],
    ports: readonly [number, number],
    found: Found,
    problem: (problem: CaptureProblem) => void,
  ) {
    this.ends = ends;
    this.#found = found;
    this.#problem = problem;
    const [one, other] = ports.map((port) => port === MODBUS_PORT);
    this.#known = one === true || other === true;
    this.#maySecure = this.#known || ports.includes(SECURE_PORT);
    this.server = one === other ? -1 : one ? 0 : 1;
  }

  segment(side: 0 | 1, flags: number, segment: Segment, acknowledged: number): void {
    const half = this.#halves[side];
    if ((flags & SYN) !== 0) {
      if (half.next !== undefined && half.next !== ((segment.seq + 1) | 0)) this.#restart();
      half.next = (segment.seq + 1) | 0;
      half.lost = false;
      // The server is the one that answers a SYN.
      this.server = (flags & ACK) === 0 ? 1 - side : side;
    }
    if ((flags & RST) !== 0) return;
    if ((flags & ACK) !== 0) this.#acknowledge(this.#halves[side === 0 ? 1 : 0], side === 0 ? 1 : 0, acknowledged);
    if (segment.to + segment.missing > segment.from) this.#take(half, side, segment);
  }

  /** Another connection between the same ends. */
  #restart(): void {
    for (const [side, half] of this.#halves.entries()) {
      this.#flush(half, side as 0 | 1);
      half.next = undefined;
      half.rest = undefined;
      half.lost = true;
    }
  }

  /** What the other end has acknowledged and the file has not is lost. */
  #acknowledge(half: Half, side: 0 | 1, acknowledged: number): void {
    const [first] = half.waiting;
    if (first !== undefined && distance(acknowledged, first.seq) > 0) this.#skipHole(half, side);
  }

  #take(half: Half, side: 0 | 1, segment: Segment): void {
    const seq = segment.seq | 0;
    half.next ??= seq;
    const ahead = distance(seq, half.next);
    if (ahead > 0) {
      half.waiting.push({ ...segment, seq });
      half.waiting.sort((a, b) => distance(a.seq, b.seq));
      if (half.waiting.length > MOST_WAITING) this.#skipHole(half, side);
      return;
    }
    this.#accept(half, side, segment, -ahead);
    this.#goOn(half, side);
  }

  /** Takes what a segment has behind its first `known` bytes. */
  #accept(half: Half, side: 0 | 1, { seq, bytes, from, to, missing, packet, time }: Segment, known: number): void {
    const length = to - from + missing;
    if (known >= length) return;
    half.next = (seq + length) | 0;
    if (from + known < to) this.#feed(half, side, bytes, from + known, to, packet, time);
    if (missing === 0) return;
    this.#problem({ code: 'packet-cut', place: { kind: 'packet', numbers: [packet] }, missing });
    this.#lose(half);
  }

  /** Takes the segments that waited and whose turn it is. */
  #goOn(half: Half, side: 0 | 1): void {
    for (let [first] = half.waiting; first !== undefined; [first] = half.waiting) {
      const ahead = distance(first.seq, half.next ?? first.seq);
      if (ahead > 0) return;
      half.waiting.shift();
      this.#accept(half, side, first, -ahead);
    }
  }

  #skipHole(half: Half, side: 0 | 1): void {
    const [first] = half.waiting;
    if (first === undefined) return;
    const missing = distance(first.seq, half.next ?? first.seq);
    if (missing > 0 && this.#carriage !== undefined) {
      this.#problem({ code: 'segment-lost', place: { kind: 'packet', numbers: [first.packet] }, missing });
    }
    half.next = first.seq;
    this.#lose(half);
    this.#goOn(half, side);
  }

  #lose(half: Half): void {
    half.rest = undefined;
    half.restPackets = [];
    half.lost = true;
    half.doubted = true;
  }

  #flush(half: Half, side: 0 | 1): void {
    while (half.waiting.length > 0) this.#skipHole(half, side);
  }

  /** What came without an order: a datagram of UDP. */
  datagram(side: 0 | 1, bytes: Uint8Array, from: number, to: number, packets: readonly number[], time: number): void {
    const carriage = carriageOf(bytes, from, to) ?? (this.#known && isMbapAt(bytes, from, to) ? 'tcp' : undefined);
    if (carriage === undefined) return;
    let at = from;
    while (at < to) {
      const end = frameEnd(carriage, bytes, at, to);
      if (end < 0) break;
      this.#found.add(this, side, carriage, bytes, at, end, time, packets);
      at = end;
    }
    if (at < to) this.#problem({ code: 'left-over', place: { kind: 'packet', numbers: packets }, bytes: to - at });
  }

  #feed(half: Half, side: 0 | 1, bytes: Uint8Array, from: number, to: number, packet: number, time: number): void {
    if (this.#carriage === undefined) {
      if (!this.#tell(half, side, bytes, from, to, packet, time)) return;
      this.#readHeld(side === 0 ? 1 : 0);
    }
    this.#read(half, side, bytes, from, to, packet, time);
  }

  #read(half: Half, side: 0 | 1, bytes: Uint8Array, from: number, to: number, packet: number, time: number): void {
    const carriage = this.#carriage as Carriage;
    let [source, at, end] = [bytes, from, to];
    let packets: readonly number[] = [packet];
    if (half.rest !== undefined) {
      const joined = joinBytes([half.rest, bytes.subarray(from, to)]);
      [source, at, end] = [joined, 0, joined.length];
      packets = half.restPackets.at(-1) === packet ? half.restPackets : [...half.restPackets, packet];
      half.rest = undefined;
    }
    while (at < end) {
      const isSegment = source === bytes && at === from && frameEnd(carriage, source, at, end) === to;
      const next = half.doubted ? sureEnd(carriage, source, at, end, isSegment) : frameEnd(carriage, source, at, end);
      if (next === MORE) {
        half.rest = source.slice(at, end);
        half.restPackets = [...packets];
        half.restTime = time;
        half.lost = false;
        return;
      }
      if (next === NO_FRAME) {
        const place = nextFrame(carriage, source, at, end);
        // A stream that is joined in its middle begins with the end of a frame, which is no fault of the file.
        const code = half.lost ? 'joined' : 'skipped';
        this.#problem({ code, place: { kind: 'packet', numbers: [packet] }, bytes: place - at });
        at = place;
        half.lost = true;
      } else {
        this.#found.add(this, side, carriage, source, at, next, time, packets);
        at = next;
        half.lost = false;
        half.doubted = false;
      }
      packets = [packet];
    }
  }

  /**
   * Whether it is known what the stream carries, by a segment alone or with those before it, which wait until then: a frame of a serial
   * line may come in many.
   */
  #tell(half: Half, side: 0 | 1, bytes: Uint8Array, from: number, to: number, packet: number, time: number): boolean {
    if (this.#tries >= TRIES && !this.#known) return false;
    this.#tries++;
    if (this.#maySecure && TLS.every((byte, index) => bytes[from + index] === byte)) {
      if (!this.#isSecure) this.#problem({ code: 'encrypted', place: { kind: 'packet', numbers: [packet] } });
      this.#isSecure = true;
    }
    if (this.#isSecure) return false;
    const { rest, restPackets } = half;
    const alone = carriageOf(bytes, from, to);
    if (alone !== undefined) {
      this.#carriage = alone;
      // What came before is not the beginning of what is whole by itself.
      this.#readHeld(side);
      half.rest = undefined;
      return true;
    }
    const all = rest === undefined ? bytes.subarray(from, to) : joinBytes([rest, bytes.subarray(from, to)]);
    const joined = rest === undefined ? undefined : carriageOf(all, 0, all.length);
    if (joined !== undefined) this.#carriage = joined;
    else if (this.#known && (this.#tries >= TRIES || isMbapAt(all, 0, all.length))) this.#carriage = 'tcp';
    if (this.#carriage !== undefined) return true;
    half.rest = all.slice(-MOST_RTU);
    half.restPackets = [...restPackets, packet];
    half.restTime = time;
    return false;
  }

  /** Reads what waited until it was known what the stream carries. */
  #readHeld(side: 0 | 1): void {
    const half = this.#halves[side];
    const { rest, restPackets, restTime } = half;
    half.rest = undefined;
    if (rest !== undefined) this.#read(half, side, rest, 0, rest.length, restPackets.at(-1) ?? 0, restTime);
  }

  /** Takes what still waits when the file has ended. */
  end(): void {
    for (const [side, half] of this.#halves.entries()) {
      this.#flush(half, side as 0 | 1);
      if (this.#carriage === undefined && this.#known) {
        this.#carriage = 'tcp';
        for (const one of [0, 1] as const) this.#readHeld(one);
      }
      if (half.rest === undefined || this.#carriage === undefined) continue;
      const { rest, restPackets: packets, restTime } = half;
      const to = sureEnd(this.#carriage, rest, 0, rest.length, true);
      if (to === rest.length) this.#found.add(this, side as 0 | 1, this.#carriage, rest, 0, to, restTime, packets);
      else {
        this.#problem({
          code: 'frame-cut',
          place: { kind: 'packet', numbers: half.restPackets },
          bytes: half.rest.length,
        });
      }
    }
  }
}
