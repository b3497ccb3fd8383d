import { isTold, type Known, knownOfNumber, numberOfKnown } from './known.ts';
import { countsColumn, timesColumn } from './numbers.ts';
import type { CaptureRecord, Carried, Place, RecordSide } from './record.ts';

const TRANSPORTS: readonly Carried[] = ['rtu', 'ascii', 'tcp'];
const SIDES: readonly (RecordSide | undefined)[] = [undefined, 'request', 'response'];
const PLACES: readonly Place['kind'][] = ['live', 'packet', 'text', 'bytes'];
/** The numbers of a packet's place that stand aside, because a frame lies in several packets. */
const SEVERAL = 0;

/** Bytes that are kept as a view are those of a buffer at least this long, which holds many records. */
const SHARED = 4096;
const CHUNK = 1 << 16;
const SIDE_SHIFT = 2;
const PLACE_SHIFT = 4;
const LOW_BITS = 3;

/** What is kept of a record, in columns: some 20 bytes, and its own if nothing else holds them. */
export class Records {
  readonly #sources: Uint8Array[] = [];
  readonly #sourceOf = new Map<ArrayBufferLike, number>();
  #chunk = -1;
  #used = CHUNK;
  readonly #source = countsColumn();
  readonly #from = countsColumn();
  readonly #length = countsColumn();
  readonly #time = timesColumn();
  readonly #kinds = countsColumn();
  readonly #ends = countsColumn();
  readonly #endNames: (readonly [from: string | undefined, to: string | undefined])[] = [];
  readonly #endNumbers = new Map<string | undefined, Map<string | undefined, number>>();
  readonly #first = countsColumn();
  readonly #second = countsColumn();
  readonly #numbers = new Map<number, readonly number[]>();
  readonly #known = countsColumn();
  readonly #told = new Map<number, Known>();

  get size(): number {
    return this.#kinds.length;
  }

  add({ bytes, time, side, transport, from, to, place, known }: CaptureRecord): void {
    const index = this.size;
    this.#known.push(numberOfKnown(known));
    if (isTold(known)) this.#told.set(index, known);
    this.#keep(bytes);
    this.#time.push(time ?? Number.NaN);
    this.#kinds.push(
      TRANSPORTS.indexOf(transport) | (SIDES.indexOf(side) << SIDE_SHIFT) | (PLACES.indexOf(place.kind) << PLACE_SHIFT),
    );
    this.#ends.push(this.#endsNumber(from, to));
    if (place.kind === 'packet') {
      const [only = SEVERAL] = place.numbers;
      if (place.numbers.length !== 1) this.#numbers.set(index, [...place.numbers]);
      this.#first.push(place.numbers.length === 1 ? only : SEVERAL);
      this.#second.push(0);
    } else {
      this.#first.push(place.kind === 'live' ? 0 : place.from);
      this.#second.push(place.kind === 'live' ? 0 : place.to);
    }
  }

  /** The records from one on. Their bytes are copied out of what is much longer, which goes with the others. */
  behind(first: number): Records {
    const rest = new Records();
    for (let at = first; at < this.size; at++) {
      const index = rest.size;
      const bytes = this.bytes(at);
      const [told, numbers] = [this.#told.get(at), this.#numbers.get(at)];
      if (told) rest.#told.set(index, told);
      if (numbers) rest.#numbers.set(index, numbers);
      rest.#keep(bytes.buffer.byteLength > CHUNK ? bytes.slice() : bytes);
      rest.#ends.push(rest.#endsNumber(...this.ends(at)));
      rest.#known.push(this.#known.at(at));
      rest.#time.push(this.#time.at(at));
      rest.#kinds.push(this.#kinds.at(at));
      rest.#first.push(this.#first.at(at));
      rest.#second.push(this.#second.at(at));
    }
    return rest;
  }

  /** Bytes of a long buffer stay where they are; others are copied. */
  #keep(bytes: Uint8Array): void {
    this.#length.push(bytes.length);
    if (bytes.buffer.byteLength >= SHARED && bytes.length < bytes.buffer.byteLength) {
      let source = this.#sourceOf.get(bytes.buffer);
      if (source === undefined) {
        source = this.#sources.push(new Uint8Array(bytes.buffer)) - 1;
        this.#sourceOf.set(bytes.buffer, source);
      }
      this.#source.push(source);
      this.#from.push(bytes.byteOffset);
      return;
    }
    if (this.#chunk < 0 || this.#used + bytes.length > (this.#sources[this.#chunk]?.length ?? 0)) {
      this.#chunk = this.#sources.push(new Uint8Array(Math.max(CHUNK, bytes.length))) - 1;
      this.#used = 0;
    }
    this.#sources[this.#chunk]?.set(bytes, this.#used);
    this.#source.push(this.#chunk);
    this.#from.push(this.#used);
    this.#used += bytes.length;
  }

  #endsNumber(from: string | undefined, to: string | undefined): number {
    // Most records name the same few ends: no text is made of both.
    let numbers = this.#endNumbers.get(from);
    if (numbers === undefined) {
      numbers = new Map();
      this.#endNumbers.set(from, numbers);
    }
    let number = numbers.get(to);
    if (number === undefined) {
      number = this.#endNames.push([from, to]) - 1;
      numbers.set(to, number);
    }
    return number;
  }

  bytes(index: number): Uint8Array {
    const from = this.#from.at(index);
    const source = this.#sources[this.#source.at(index)] as Uint8Array;
    return source.subarray(from, from + this.#length.at(index));
  }

  length(index: number): number {
    return this.#length.at(index);
  }

  time(index: number): number | undefined {
    const time = this.#time.at(index);
    return Number.isNaN(time) ? undefined : time;
  }

  transport(index: number): Carried {
    return TRANSPORTS[this.#kinds.at(index) & LOW_BITS] as Carried;
  }

  side(index: number): RecordSide | undefined {
    return SIDES[(this.#kinds.at(index) >> SIDE_SHIFT) & LOW_BITS];
  }

  isLive(index: number): boolean {
    return this.#kinds.at(index) >> PLACE_SHIFT === 0;
  }

  /** What its source knows of it. */
  known(index: number): Known | undefined {
    return this.#told.get(index) ?? knownOfNumber(this.#known.at(index));
  }

  place(index: number): Place {
    const kind = PLACES[this.#kinds.at(index) >> PLACE_SHIFT] as Place['kind'];
    const from = this.#first.at(index);
    if (kind === 'live') return { kind };
    if (kind === 'packet') return { kind, numbers: this.#numbers.get(index) ?? [from] };
    return { kind, from, to: this.#second.at(index) };
  }

  /** Who spoke, and to whom. */
  ends(index: number): readonly [from: string | undefined, to: string | undefined] {
    return this.#endNames[this.#ends.at(index)] ?? [undefined, undefined];
  }

  record(index: number): CaptureRecord {
    const [from, to] = this.ends(index);
    const time = this.time(index);
    const side = this.side(index);
    const known = this.known(index);
    return {
      bytes: this.bytes(index),
      ...(time !== undefined && { time }),
      ...(side !== undefined && { side }),
      transport: this.transport(index),
      ...(from !== undefined && { from }),
      ...(to !== undefined && { to }),
      place: this.place(index),
      ...(known && { known }),
    };
  }
}
