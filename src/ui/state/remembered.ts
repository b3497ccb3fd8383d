/**
 * A choice kept in this browser. Where storage is refused (private windows, full disks) the choice holds until the page
 * is closed.
 */
export class Remembered<T> {
  private readonly key: string;
  private held: T;

  constructor(name: string, initial: T, read: (value: unknown) => T | undefined) {
    this.key = `framewright.${name}`;
    this.held = initial;
    try {
      this.held = read(JSON.parse(localStorage.getItem(this.key) ?? 'null')) ?? initial;
    } catch {
      // What is stored is not to be had, or not ours: the initial choice stands.
    }
  }

  get value(): T {
    return this.held;
  }

  set value(value: T) {
    this.held = value;
    try {
      localStorage.setItem(this.key, JSON.stringify(value));
    } catch {
      // Held in memory all the same.
    }
  }
}
