import { batch, computed, type Signal, signal } from '@preact/signals-core';
import { dictionary } from '../modbus/index.ts';
import { type StepPlace, StepRows } from '../workbench/index.ts';
import type { After } from './address.ts';
import type { KeptChoice } from './storage.ts';

/** Rows a second that can be chosen. */
export const stepSpeeds = [1, 2, 4, 10, 30] as const;
export type StepSpeed = (typeof stepSpeeds)[number];

/** What is kept for the next time. */
interface Kept {
  /** Whether all bytes are folded at first. */
  readonly folded: KeptChoice<boolean>;
  readonly speed: KeptChoice<StepSpeed>;
}

/** Goes through the steps of a checksum: row by row, byte by byte, and by itself. */
export class Stepper {
  readonly rows: Signal<StepRows>;
  readonly place: Signal<StepPlace> = signal({ at: 0, shift: 0 });
  /** The row of the place. */
  readonly row = computed(() => this.rows.value.row(this.place.value));
  readonly atLast = computed(() => this.row.value === this.rows.value.length - 1);
  readonly playing = signal(false);
  readonly bytes: number;
  readonly #kept: Kept;
  readonly #every: After;
  #pause = () => {};

  /**
   * @param bytes how many there are, at least one
   * @param every calls something every so many milliseconds, and answers how to end that
   */
  constructor(bytes: number, kept: Kept, every: After) {
    const folded = kept.folded.value;
    this.rows = signal(new StepRows(bytes, () => !folded));
    this.bytes = bytes;
    this.#kept = kept;
    this.#every = every;
  }

  /** Goes some rows on, or back. */
  readonly move = (by: number): void => {
    this.stop();
    this.#choose(this.row.peek() + by);
  };

  /** Goes to a place, and unfolds its byte if it is a shift. */
  readonly go = (place: StepPlace): void => {
    this.stop();
    if (place.shift > 0 && !this.rows.peek().open(place.at)) this.toggle(place.at);
    this.place.value = place;
  };

  /** Folds or unfolds a byte, and goes to it. */
  readonly toggle = (at: number): void => {
    const rows = this.rows.peek();
    this.#fold((each) => rows.open(each) !== (each === at), { at, shift: 0 });
  };

  /** Folds or unfolds all bytes, now and for the next time. */
  readonly foldAll = (folded: boolean): void => {
    this.#kept.folded.value = folded;
    this.#fold(() => !folded, this.place.peek());
  };

  /** Goes on by itself until the last row, or stops doing so. */
  readonly play = (): void => {
    const { playing } = this;
    if (playing.peek()) this.stop();
    else if (!this.atLast.peek()) this.#run();
  };

  readonly stop = (): void => {
    this.#pause();
    this.playing.value = false;
  };

  get speed(): StepSpeed {
    return this.#kept.speed.value;
  }

  set speed(speed: StepSpeed) {
    this.#kept.speed.value = speed;
    if (this.playing.peek()) this.#run();
  }

  /** Does what a key does, as browsers name it, with `Shift ` before it. Answers whether it does anything. */
  readonly press = (key: string): boolean => {
    const act = this.#keys[key];
    act?.();
    return act !== undefined;
  };

  readonly #keys: Readonly<Record<string, () => void>> = dictionary({
    ArrowDown: () => this.move(1),
    ArrowUp: () => this.move(-1),
    ArrowRight: () => this.#unfold(),
    ArrowLeft: () => this.#leave(),
    'Shift ArrowRight': () => this.foldAll(false),
    'Shift ArrowLeft': () => this.foldAll(true),
    PageDown: () => this.#toByte(this.place.peek().at + 1),
    PageUp: () => this.#toByte(this.place.peek().at - (this.place.peek().shift === 0 ? 1 : 0)),
    Home: () => this.move(-Infinity),
    End: () => this.move(Infinity),
    ' ': this.play,
    '+': () => this.#faster(1),
    'Shift +': () => this.#faster(1),
    '-': () => this.#faster(-1),
  });

  #choose(row: number): void {
    const rows = this.rows.peek();
    this.place.value = rows.place(Math.max(0, Math.min(rows.length - 1, row)));
  }

  #run(): void {
    this.#pause();
    this.playing.value = true;
    this.#pause = this.#every(1000 / this.#kept.speed.value, () => {
      if (this.atLast.peek()) this.stop();
      else this.#choose(this.row.peek() + 1);
    });
  }

  #faster(by: 1 | -1): void {
    const next = stepSpeeds[stepSpeeds.indexOf(this.#kept.speed.value) + by];
    if (next !== undefined) this.speed = next;
  }

  #fold(isOpen: (at: number) => boolean, { at, shift }: StepPlace): void {
    const rows = new StepRows(this.bytes, isOpen);
    batch(() => {
      this.rows.value = rows;
      // A shift that is folded away is at its byte.
      this.place.value = { at, shift: rows.open(at) ? shift : 0 };
    });
  }

  #toByte(at: number): void {
    this.go({ at: Math.max(0, Math.min(this.bytes - 1, at)), shift: 0 });
  }

  /** Unfolds a byte; if it is unfolded, goes into it, as in any tree. */
  #unfold(): void {
    const { at, shift } = this.place.peek();
    if (!this.rows.peek().open(at)) this.toggle(at);
    else if (shift === 0) this.move(1);
  }

  /** Leaves the shifts for their byte; there, folds it. */
  #leave(): void {
    const { at, shift } = this.place.peek();
    if (shift > 0) this.go({ at, shift: 0 });
    else if (this.rows.peek().open(at)) this.toggle(at);
  }
}
