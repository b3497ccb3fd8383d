/** The quickest answers that are kept, and the last ones. */
const QUICKEST = 9;
const LAST = 15;
/** Late answers in a row after which it is said that the time-out is too short. */
const SLOW = 3;
/** Exceptions after which it is watched whether a reply follows. */
const WATCHED = 3;
/** The longest silence that is left after one of the first replies, in milliseconds. */
const LONGEST_SILENCE = 100;
/** After the first replies it is three times what an answer took; after the others, what it took. */
const FIRST = { replies: 4, times: 3 };
/** Replies that have to agree until it is clear what they answer; of a device that has not answered for sure yet. */
const AGREEING = { known: 2, unknown: 5 };
/** A device that was late more often lately is erratic. */
const ERRATIC = 2.5;
/** Its multiples lie evenly between the whole numbers. */
const GOLDEN = 0.618;
/** What a timer may be late, in milliseconds. */
const JITTER = 10;
/** Times that differ by less, in milliseconds, are the same: browsers round them, and a byte waits for the page's next turn. */
const SAME = 1;

/** A reply that may be the answer to an earlier request, or to this one. Both times are counted from the request. */
interface Unsure {
  readonly asOwn: number;
  readonly asEarlier: number;
}

/** How quickly a device answers, in milliseconds from the request to the first byte of the reply. */
export class Pace {
  /** A reply has come after an exception, or after a damaged frame, to the same request. */
  answersTwice = false;
  /** The quickest first. */
  #quickest: number[] = [];
  #last: number[] = [];
  #late: number[] = [];
  /** It was late for sure since it answered in time for sure. */
  #isLate = false;
  #unsure: Unsure[] = [];
  #doubts = 0;
  /** How often it was late; each answer in time makes it a twentieth less. */
  #lateness = 0;
  #refusals = 0;

  /** A reply has come that was the answer to its request for sure. */
  answered(after: number): void {
    const slowest = this.#quickest.at(-1);
    if (slowest === undefined || !this.isKnown || after < slowest) {
      this.#quickest = [...this.#quickest, after].sort((one, other) => one - other).slice(0, QUICKEST);
    }
    this.#last.push(after);
    if (this.#last.length > LAST) this.#last.shift();
    if (this.#late.length > 0) this.#late = [];
    this.#isLate = false;
    this.#lateness *= 0.95;
    if (this.#doubts > 0) {
      this.#unsure = [];
      this.#doubts = 0;
    }
  }

  /** Whether it is late so often that its times prove little. */
  get isErratic(): boolean {
    return this.#lateness > ERRATIC;
  }

  /** A reply has come after its request was given up; `isSure` says that it can be no other request's. */
  late(after: number, isSure: boolean): void {
    this.#late = [...this.#late, after].slice(-SLOW);
    if (isSure) this.#lateness += 1;
    this.#isLate ||= isSure;
  }

  /** An exception has come. Answers whether it is waited for a reply behind it. */
  refused(): boolean {
    this.#refusals += 1;
    return this.answersTwice || this.#refusals <= WATCHED;
  }

  /** The slowest of the last answers, if they all were late: the time-out is too short. */
  get slow(): number | undefined {
    return this.#late.length < SLOW ? undefined : Math.max(...this.#late);
  }

  get hasAnswered(): boolean {
    return this.#quickest.length > 0;
  }

  /** Whether enough answers are known: one more is hardly quicker than all of them. */
  get isKnown(): boolean {
    return this.#quickest.length === QUICKEST;
  }

  /**
   * The silence that is left behind a reply while few are known: a second copy comes sooner than the next answer would, and
   * so is seen to be one.
   */
  get silence(): number {
    if (this.isKnown) return 0;
    const times = this.#last.length < FIRST.replies ? FIRST.times : 1;
    return Math.min(times * Math.max(0, ...this.#last), LONGEST_SILENCE);
  }

  /**
   * How much longer the next request waits, as a part of the time-out: while it is not clear which request a reply answers,
   * the times from one request to the next are made to differ.
   */
  get pause(): number {
    return (this.#doubts * GOLDEN) % 1;
  }

  /** The device has hardly ever taken longer. */
  get longest(): number {
    return 1.5 * Math.max(0, ...this.#last) + JITTER;
  }

  /**
   * Whether no answer of the device comes so soon. The margin is what the quickest answers differ by, at least a millisecond, so
   * that a device whose time varies is not taken for one that is too quick.
   */
  isTooSoon(after: number): boolean {
    const [least, most] = [this.#quickest[0], this.#quickest[QUICKEST - 1]];
    if (least === undefined) return false;
    return after < (most === undefined ? least / 2 : least - Math.max(SAME, most - least));
  }

  /** Whether no answer of the device comes half as soon. */
  isMuchTooSoon(after: number): boolean {
    return after < (this.#quickest[0] ?? 0) / 2;
  }

  /** Whether the device has never taken such a time. */
  isOdd(after: number): boolean {
    return this.hasAnswered ? this.isTooSoon(after) || after > this.longest : this.#isLate;
  }

  /** A reply has come, and one more may. */
  doubt(): void {
    this.#doubts += 1;
  }

  /** Notes a reply that may answer an earlier request. */
  note(unsure: Unsure): void {
    this.doubt();
    this.#unsure = [...this.#unsure, unsure].slice(-AGREEING.unknown);
  }

  /**
   * Whether it has become clear that the last replies were the answers to their own requests: their times from those agree,
   * and their times from the earlier ones do not.
   */
  isClear(): boolean {
    const needed = this.hasAnswered && !this.isErratic ? AGREEING.known : AGREEING.unknown;
    if (!this.hasAnswered && this.#isLate) return false;
    const last = this.#unsure.slice(-needed);
    if (last.length < needed) return false;
    if (this.hasAnswered && !last.every(({ asOwn }) => this.#isUsual(asOwn))) return false;
    const own = spreadOf(last.map(({ asOwn }) => asOwn));
    const earlier = spreadOf(last.map(({ asEarlier }) => asEarlier));
    return own < earlier / 2 && own <= JITTER / 2 + earlier / (this.hasAnswered ? 8 : 20);
  }

  #isUsual(after: number): boolean {
    const middle = this.#last.toSorted((one, other) => one - other)[this.#last.length >> 1] ?? 0;
    return 2 * after >= (this.#quickest[0] ?? 0) && after <= 1.5 * middle + JITTER;
  }
}

const spreadOf = (times: readonly number[]): number => Math.max(...times) - Math.min(...times);
