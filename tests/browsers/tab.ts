/** What a browser's own protocol must be able to do for the driver. */
export interface Tab {
  goto(url: string): Promise<void>;
  /** Runs a function in the page; it sees its arguments and the page, and nothing of this module. */
  run<A extends readonly unknown[], T>(fn: (...args: A) => T, ...args: A): Promise<T>;
  /** A click of the mouse on the middle of what the selector finds. */
  click(selector: string): Promise<void>;
  /** Types text where the focus is. */
  type(text: string): Promise<void>;
  press(key: Key): Promise<void>;
  /** Chooses a file in a field for files. */
  attach(selector: string, path: string): Promise<void>;
  reload(): Promise<void>;
  back(): Promise<void>;
  close(): Promise<void>;
}

export type Key = 'Enter' | 'Escape' | 'Tab' | 'F8' | 'ArrowDown';

/** A browser that is installed here; `undefined` if it is not. */
export interface Browser {
  readonly name: string;
  open(): Promise<Tab>;
  close(): Promise<void>;
}
