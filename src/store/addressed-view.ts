import { type Signal, signal, untracked } from '@preact/signals-core';
import type { Page } from './page.ts';
import { type OtherView, partsAt, type ViewParts, viewAt } from './views.ts';

/**
 * What a view beside the Frame view shows by its address, `#name?key=value`, as typed: a reload, a link and Back find it as it
 * was. It is made when the view is opened, and stopped when the view is left.
 */
export class AddressedView<S extends object> {
  readonly shown: Signal<S>;
  /** Lets the address follow what is shown; that of another view stays as it is. */
  protected readonly follow: () => void;
  readonly #stopReading: () => void;

  /**
   * @param read what the parts of an address show
   * @param write the parts of the address that shows the same; those with an empty text are left out
   */
  constructor(
    page: Page,
    name: OtherView,
    read: (parts: ReadonlyMap<string, string>) => S,
    write: (shown: Readonly<S>) => ViewParts,
  ) {
    const { given } = page.address;
    const first = given.peek();
    const shownAt = (hash: string) => untracked(() => read(partsAt(hash)));
    this.shown = signal(shownAt(first.hash));
    this.follow = () => {
      if (viewAt(given.peek().hash) === name) page.follow(name, () => write(this.shown.peek()));
    };
    this.#stopReading = given.subscribe((next) => {
      if (next !== first && viewAt(next.hash) === name) this.shown.value = shownAt(next.hash);
    });
  }

  /** Changes what is shown while something is typed: the address follows at a pause. */
  readonly change = (part: Partial<S>): void => {
    this.shown.value = { ...this.shown.peek(), ...part };
    this.follow();
  };

  /** From now on no address is read. */
  stop(): void {
    this.#stopReading();
  }
}
