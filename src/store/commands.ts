import { signal } from '@preact/signals-core';
import { flag } from '../workbench/index.ts';
import type { Page } from './page.ts';
import { KeptChoice, type PageStorage } from './storage.ts';
import { type OtherView, otherViews } from './views.ts';

/** Acts that a part of the page can do while it stands. */
export type OfferedId =
  | 'stop'
  | 'close'
  | 'focus-input'
  | 'send'
  | 'copy-frame'
  | 'next-fault'
  | 'previous-fault'
  | 'print';
export type CommandId = OfferedId | `view-${OtherView | 'frame'}` | 'keys';

/** An act with a key. */
export interface Command {
  readonly id: CommandId;
  /** As `Ctrl+Enter`: Ctrl, Alt and Shift before the name that browsers give the key. Shift is not said of a character. */
  readonly key: string;
  /** Whether it can be done now. */
  readonly when: () => boolean;
  readonly run: () => void;
}

/** A key that was pressed. */
export interface KeyPress {
  /** As browsers name it: `F8`, or the character. */
  readonly key: string;
  /** Ctrl, or the command key of a Mac. */
  readonly ctrl: boolean;
  readonly alt: boolean;
  readonly shift: boolean;
  /** Whether it was pressed in a field that takes text: characters are typed there. */
  readonly typing: boolean;
  /** Whether a component took the key for its own, or a dialog waits for an answer: nothing but `stop` is done then. */
  readonly taken: boolean;
}

/** Every act of the page that has a key. Of two with one key the first that can be done is done. */
export class Commands {
  readonly table: readonly Command[];
  /** Whether keys without Ctrl that are characters are commands; speech input types them unasked. */
  readonly singleKeys: KeptChoice<boolean>;
  /** Whether the list of keys is shown. */
  readonly listed = signal(false);
  readonly #offers = new Map<OfferedId, readonly (() => void)[]>();
  /** A command that is carried out as soon as it is offered. */
  #awaited: OfferedId | undefined;

  constructor(page: Page, storage: PageStorage) {
    this.singleKeys = new KeptChoice(storage, 'single-keys', true, flag);
    const view = (of: OtherView | undefined, key: string): Command => ({
      id: `view-${of ?? 'frame'}`,
      key,
      when: () => page.view.peek() !== of,
      run: () => page.open(of),
    });
    this.table = [
      this.#offered('stop', 'Escape'),
      this.#offered('close', 'Escape'),
      {
        ...this.#offered('focus-input', 'Ctrl+K'),
        when: () => true,
        run: () => this.#runSoon('focus-input', () => page.open(undefined)),
      },
      this.#offered('send', 'Ctrl+Enter'),
      this.#offered('copy-frame', 'c'),
      this.#offered('next-fault', 'F8'),
      this.#offered('previous-fault', 'Shift+F8'),
      this.#offered('print', 'Ctrl+P'),
      ...[undefined, ...otherViews].map((of, index) => view(of, String(index + 1))),
      ...['?', 'Ctrl+/'].map(
        (key): Command => ({ id: 'keys', key, when: () => true, run: () => (this.listed.value = true) }),
      ),
    ];
  }

  /** Lets a part of the page carry out a command; what was offered last does it. Answers what ends the offer. */
  offer(id: OfferedId, run: () => void): () => void {
    this.#offers.set(id, [...(this.#offers.get(id) ?? []), run]);
    if (this.#awaited === id) this.#runSoon(id);
    return () =>
      this.#offers.set(
        id,
        (this.#offers.get(id) ?? []).filter((other) => other !== run),
      );
  }

  /** The first key that a command has now. */
  keyOf(id: CommandId): string | undefined {
    return this.table.find((command) => command.id === id && (command.key.length > 1 || this.singleKeys.value))?.key;
  }

  /** Does what a key is for. Answers whether it is for anything now. */
  press(press: KeyPress): boolean {
    const name = nameOf(press);
    if (name.length === 1 && (press.typing || !this.singleKeys.value)) return false;
    const found = this.table.find(({ id, key, when }) => key === name && (!press.taken || id === 'stop') && when());
    found?.run();
    return found !== undefined;
  }

  /** Carries a command out, or does what brings the part of the page that will offer it. */
  #runSoon(id: OfferedId, bring?: () => void): void {
    const run = this.#offers.get(id)?.at(-1);
    this.#awaited = run ? undefined : id;
    (run ?? bring)?.();
  }

  #offered(id: OfferedId, key: string): Command {
    const last = () => this.#offers.get(id)?.at(-1);
    return { id, key, when: () => last() !== undefined, run: () => last()?.() };
  }
}

function nameOf({ key, ctrl, alt, shift }: KeyPress): string {
  const character = key.length === 1;
  const held = [ctrl && 'Ctrl', alt && 'Alt', shift && !character && 'Shift'].filter(Boolean);
  return [...held, ctrl && character ? key.toUpperCase() : key].join('+');
}
