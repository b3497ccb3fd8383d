import { type SerialMode, sameBytes } from '../../modbus/index.ts';
import { type Arrival, Arrivals } from './arrivals.ts';
import { type Awaited, anyFrame } from './find-frame.ts';
import { type Owed, OwedReplies } from './owed.ts';
import { Pace } from './pace.ts';
import type { Stray } from './result.ts';
import type { LineTimes, TransactionRules } from './rules.ts';

/** Frames that are remembered, and for how long, in milliseconds: the same one again may be a second copy. */
const MOST_FRAMES = 8;
const REMEMBERED = 250;
/** How long a line is looked at more closely on which frames came that nobody waited for, in milliseconds. */
const TROUBLE = 60_000;
/** Requests whose last replies are remembered. */
const MOST_ANSWERS = 256;
/** So many replies to a request that all differ make it odd if one is the same as the one before. */
const CHANGING = 3;
/** So many frames that could have been copies, and were none, make a further one hardly the first copy. */
const COINCIDING = 3;
/** A line that repeats frames is left silent for longer than its copies take, up to this, in milliseconds. */
const LATEST_COPY = 100;

interface Sending {
  readonly rules: TransactionRules;
  readonly times: LineTimes;
  /** When the request was ready to be sent. */
  readonly readyAt: number;
  readonly now: number;
}

/** What one transaction leaves for the next, of an open line. Times are the clock's. */
export class LineMemory {
  /** What has come and belongs to nothing yet. */
  readonly arrivals = new Arrivals();
  readonly owed = new OwedReplies();
  /** When the last byte came, and when the line was, or will be, free after the last sending. */
  heardAt = Number.NEGATIVE_INFINITY;
  freeAt = Number.NEGATIVE_INFINITY;
  /** The silence in which second copies have come. */
  copiesWithin = 0;
  /** When a frame came last that was not the reply to the request before it. */
  troubledAt = Number.NEGATIVE_INFINITY;
  /** Whether the adapter gives back what is sent, once that is known. */
  echoes: boolean | undefined = undefined;
  /** The last request, if its only answer may have been its echo. */
  perhapsEcho: Uint8Array | undefined = undefined;
  readonly #paces = new Map<number, Pace>();
  #frames: Arrival[] = [];
  /** Two requests have had replies of the same bytes. */
  #alike = false;
  #coincidences = 0;
  /** By the request: the last reply, how many there were, and whether one was ever the same as the one before. */
  readonly #answers = new Map<string, { readonly bytes: Uint8Array; readonly count: number; readonly same: boolean }>();

  /** How quickly a unit answers. */
  pace(unit: number | undefined): Pace {
    const known = this.#paces.get(unit ?? -1);
    if (known) return known;
    const pace = new Pace();
    this.#paces.set(unit ?? -1, pace);
    return pace;
  }

  /** When a request may be sent: the line has been silent for long enough by then. */
  dueAt({ asked, request, transport }: Awaited, { rules, times, readyAt, now }: Sending): number {
    // The end of a frame whose beginning came before is not to be taken for the reply.
    const silence = this.goesOn(transport) ? times.silence : times.gap;
    const pace = this.pace(asked.unitId);
    const quiet =
      Math.max(
        this.owed.quietUntil(asked, request),
        this.heardAt + Math.max(1.5 * this.copiesWithin, pace.silence),
        pace.pause > 0 ? readyAt : 0,
      ) +
      pace.pause * rules.timeout;
    // On a line that is never silent, nothing would ever be sent.
    const latest = Math.max(readyAt + rules.timeout + times.longest, quiet);
    return now < latest ? Math.max(this.freeAt, this.heardAt + silence, quiet) : now;
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

  /** Adds a piece of at most `MOST_PIECE` bytes. Answers what had to go to make room for it: the oldest. */
  add(bytes: Uint8Array, at: number, transport: SerialMode): Stray[] {
    const { arrivals } = this;
    const gone: Stray[] = [];
    while (arrivals.room < bytes.length) {
      const frame = anyFrame(arrivals.bytes, transport);
      gone.push(...this.takeNoise(frame?.from ?? bytes.length - arrivals.room));
      if (frame !== undefined) gone.push(this.stray(arrivals.take(frame.to - frame.from)));
    }
    arrivals.add(bytes, at);
    this.heardAt = at;
    return gone;
  }

  /** Takes all that has come and that nobody waits for. */
  drain(transport: SerialMode): Stray[] {
    const { arrivals } = this;
    const strays: Stray[] = [];
    while (arrivals.length > 0) {
      const frame = anyFrame(arrivals.bytes, transport);
      strays.push(...this.takeNoise(frame?.from ?? arrivals.length));
      if (frame !== undefined) strays.push(this.stray(arrivals.take(frame.to - frame.from)));
    }
    return strays;
  }

  /** Takes bytes that are not a frame. */
  takeNoise(length: number): Stray[] {
    return this.arrivals.takePieces(length).map((arrival) => ({ what: 'noise', ...arrival }));
  }

  /** What a frame is that nobody waits for. */
  stray(arrival: Arrival): Stray {
    if (this.perhapsEcho !== undefined && sameBytes(arrival.bytes, this.perhapsEcho)) {
      this.perhapsEcho = undefined;
      // So the first one was the echo.
      this.echoes = true;
    }
    const { bytes, at } = arrival;
    const first = this.copied(arrival);
    this.remember(arrival);
    const owed = this.owed.answeredBy(bytes, at, { weak: first === undefined, passed: first === undefined });
    if (owed !== undefined || first !== undefined) this.troubledAt = at;
    if (owed !== undefined) {
      if (owed.weak && !owed.passed) this.pace(owed.asked.unitId).answersTwice = true;
      return this.late(arrival, owed, true);
    }
    if (first === undefined) return { what: 'other', ...arrival };
    this.repeats(at - first.at);
    return { what: 'copy', ...arrival };
  }

  /** The frame is the reply to a request that was given up. */
  late(arrival: Arrival, owed: Owed, isSure: boolean): Stray {
    this.troubledAt = arrival.at;
    this.owed.settle(owed);
    if (!owed.weak || owed.passed) this.pace(owed.asked.unitId).late(arrival.at - owed.sentAt, isSure);
    return { what: 'late', ...arrival, ...(owed.perhaps === undefined && { answers: owed.request }) };
  }

  /** How long after a frame the line repeats it. */
  repeats(after: number): void {
    this.copiesWithin = Math.max(this.copiesWithin, Math.min(LATEST_COPY, after));
  }

  /** What could have been a copy was the reply: no other frame came. */
  coincided(): void {
    this.#coincidences += 1;
  }

  /**
   * Whether what could be a copy may be the first one of this line: then the reply is waited for as long as a busy computer
   * or an adapter can hold it back, since to take the copy for it would give each later request the reply to the one before.
   */
  get mayBeFirstCopy(): boolean {
    return this.copiesWithin === 0 && this.#coincidences < COINCIDING;
  }

  isTroubled(now: number): boolean {
    return now - this.troubledAt < TROUBLE;
  }

  remember(arrival: Arrival): void {
    this.#frames = [...this.#frames, arrival].slice(-MOST_FRAMES);
  }

  /** The frame of the same bytes that came a short time before, if one did. */
  copied({ bytes, at }: Arrival): Arrival | undefined {
    return this.#frames.findLast((one) => at - one.at < REMEMBERED && sameBytes(one.bytes, bytes));
  }

  /** The request got this reply, surely. */
  answered(request: Uint8Array, bytes: Uint8Array): void {
    const key = request.join();
    const last = this.#answers.get(key);
    if (last === undefined && this.#answers.size === MOST_ANSWERS) this.#answers.clear();
    if (last === undefined)
      this.#alike ||= this.#frames.some((one) => one.bytes !== bytes && sameBytes(one.bytes, bytes));
    const same = last !== undefined && (last.same || sameBytes(last.bytes, bytes));
    this.#answers.set(key, { bytes, count: (last?.count ?? 0) + 1, same });
  }

  /**
   * The frame of the same bytes that came a short time before, if this one is rather its second copy than a reply to this
   * request: what the request was answered before differs, or always changed.
   */
  perhapsCopyOf(arrival: Arrival, request: Uint8Array): Arrival | undefined {
    const first = this.copied(arrival);
    if (first === undefined) return undefined;
    const last = this.#answers.get(request.join());
    const isOdd = this.copiesWithin > 0 || (!this.#alike && this.#answers.size > CHANGING);
    if (last === undefined) return isOdd ? first : undefined;
    const isUsual = sameBytes(last.bytes, arrival.bytes) && (last.same || last.count < CHANGING);
    return isUsual ? undefined : first;
  }
}
