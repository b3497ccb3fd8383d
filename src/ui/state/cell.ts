/** What is to be done when something shown has changed. */
let draw: (() => void) | undefined;
let waiting = false;

/** A value that the page shows: setting it draws the page again, once for all that is set together. */
export class Cell<T> {
  private held: T;

  constructor(initial: T) {
    this.held = initial;
  }

  get value(): T {
    return this.held;
  }

  set value(value: T) {
    if (value === this.held) return;
    this.held = value;
    if (draw === undefined || waiting) return;
    waiting = true;
    queueMicrotask(() => {
      waiting = false;
      draw?.();
    });
  }
}

/** A value worked out from a cell's, once for each of them. */
export class Derived<S, T> {
  private readonly source: Cell<S>;
  private readonly derive: (value: S) => T;
  private from: S | undefined;
  private held: T | undefined;

  constructor(source: Cell<S>, derive: (value: S) => T) {
    this.source = source;
    this.derive = derive;
  }

  get value(): T {
    const { value } = this.source;
    if (this.held === undefined || this.from !== value) {
      this.from = value;
      this.held = this.derive(value);
    }
    return this.held;
  }
}

/** Draws now, and again whenever a cell changes. */
export function drawWith(view: () => void): void {
  draw = view;
  view();
}
