import { computed, type Signal, signal } from '@preact/signals-core';
import { sameBytes, type Transport } from '../modbus/index.ts';
import type { ByteNotation } from '../notation/index.ts';
import type { How, ItemIdentity, TextReading, TextStorage } from '../workbench/index.ts';
import type { Page } from './page.ts';

/** The text to read as it stands, and what became of it. */
export type PastedText =
  | { readonly kind: 'empty' }
  /** The reader has not come yet; `kept` is a text of before a reload, which shows no frame. */
  | { readonly kind: 'waiting'; readonly text: string; readonly kept: boolean }
  | { readonly kind: 'reading'; readonly text: string }
  /** The worker ended over it: the text may be too long for the memory there is. */
  | { readonly kind: 'failed'; readonly text: string }
  | {
      readonly kind: 'read';
      readonly reading: TextReading;
      /** The item whose frame was shown; −1 if none was. */
      readonly chosen: number;
    };

/** A worker that reads a text. */
export interface ReadingWorker {
  post(task: { readonly text: string; readonly as: ByteNotation | undefined }): void;
  end(): void;
}

/** What reads texts: it comes when there is a text. */
export interface Reader {
  readonly readText: (text: string, as: ByteNotation | undefined) => TextReading;
  readonly firstFrame: (reading: TextReading) => number;
  readonly identityOf: (reading: TextReading, index: number) => ItemIdentity | undefined;
  /** Starts a worker. `ended` is called if it does nothing any more; `died` if it had begun. */
  readonly start: (take: (reading: TextReading) => void, ended: (died: boolean) => void) => ReadingWorker;
}

/** Longer texts, in characters, are read by a worker. */
const LONG = 50_000;
/** Texts up to this long, in characters, outlive a reload. */
const KEPT = 200_000;
const KEY = 'framewright.pasted';
/** Pieces of the text on either side of a frame that say something about it. */
const PIECES = 4;

/** The text that was pasted, what it was read as, and which of its frames is shown. */
export class Pasted {
  readonly state: Signal<PastedText> = signal({ kind: 'empty' });
  /** Whether the panel with the text is open. */
  readonly opened = signal(false);
  /** Whether the reader is to come. */
  readonly wanted = computed(() => this.opened.value || this.state.value.kind === 'waiting');
  /** What the chosen item may be, and the request that it answers, or was to answer. */
  readonly identity = computed(() => {
    const { value } = this.state;
    return value.kind === 'read' ? this.#reader?.identityOf(value.reading, value.chosen) : undefined;
  });
  readonly #page: Page;
  readonly #session: () => TextStorage;
  #reader: Reader | undefined;
  #worker: ReadingWorker | undefined;

  /** `session` keeps a text until the window is closed; it may throw. */
  constructor(page: Page, session: () => TextStorage) {
    this.#page = page;
    this.#session = session;
    const text = this.#kept();
    if (text === null || text.length > LONG) return;
    this.state.value = { kind: 'waiting', text, kept: true };
    this.opened.value = true;
  }

  /** Brings what reads; a text that waits is read. */
  bring(reader: Reader): void {
    this.#reader = reader;
    const state = this.state.peek();
    if (state.kind !== 'waiting') return;
    if (state.kept) this.state.value = { kind: 'read', reading: reader.readText(state.text, undefined), chosen: -1 };
    else this.read(state.text, 'step');
  }

  /** Opens the panel and reads a text that was pasted or dropped; a blank one changes nothing. */
  readonly take = (text: string): void => {
    if (text.trim() === '') return;
    this.opened.value = true;
    this.read(text, 'step');
  };

  /** Reads a text; `as` says in which notation, if the page's own choice was not meant. */
  readonly read = (text: string, how: How, as?: ByteNotation): void => {
    this.#stop();
    this.#keep(text);
    const reader = this.#reader;
    if (text.trim() === '') this.state.value = { kind: 'empty' };
    else if (reader === undefined) this.state.value = { kind: 'waiting', text, kept: false };
    else if (text.length <= LONG) this.#took(reader.readText(text, as), how);
    else {
      this.state.value = { kind: 'reading', text };
      const took = (reading: TextReading) => {
        this.#stop();
        this.#took(reading, how);
      };
      this.#worker = reader.start(took, (died) => {
        // Without a worker the text is read here: better a page that does not answer for a while than no reading.
        if (died) this.state.value = { kind: 'failed', text };
        else took(reader.readText(text, as));
      });
      this.#worker.post({ text, as });
    }
  };

  /** Gives up what a worker reads. */
  readonly cancel = (): void => {
    this.#stop();
    this.state.value = { kind: 'empty' };
  };

  /** Shows an item's frame: as a step, or in place while somebody goes through the list. */
  readonly choose = (index: number, how: How): void => {
    const state = this.state.peek();
    if (state.kind !== 'read' || state.reading.items[index] === undefined) return;
    this.state.value = { ...state, chosen: index };
    const found = this.identity.peek();
    const [best] = found?.identities ?? [];
    if (best) this.#page.showReading(best.reading, found?.request, how);
  };

  /** What the text that bytes were read from tells of them; `undefined` if they are not the chosen item's. */
  contextOf(bytes: Uint8Array, transport: Transport | undefined) {
    const { value } = this.state;
    const found = this.identity.value;
    if (value.kind !== 'read' || found === undefined || !sameBytes(found.bytes, bytes)) return undefined;
    const { reading, chosen } = value;
    const pieces = (from: number, to: number) =>
      reading.items.slice(Math.max(0, from), to).map((item) => reading.bytes.subarray(item.from, item.to));
    return {
      // A transport that was guessed from the bytes says nothing more about them.
      transport: transport === found.identities[0]?.transport ? undefined : transport,
      ...(found.request && { request: found.request }),
      preceding: pieces(chosen - PIECES, chosen),
      following: pieces(chosen + 1, chosen + 1 + PIECES),
    };
  }

  #took(reading: TextReading, how: How): void {
    const chosen = this.#reader?.firstFrame(reading) ?? 0;
    this.state.value = { kind: 'read', reading, chosen };
    this.choose(chosen, how);
  }

  #stop(): void {
    this.#worker?.end();
    this.#worker = undefined;
  }

  #kept(): string | null {
    try {
      return this.#session().getItem(KEY);
    } catch {
      return null;
    }
  }

  #keep(text: string): void {
    try {
      if (text === '' || text.length > KEPT) this.#session().removeItem(KEY);
      else this.#session().setItem(KEY, text);
    } catch {
      // A browser that keeps nothing reads all the same.
    }
  }
}
