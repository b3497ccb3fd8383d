import { computed, type ReadonlySignal, type Signal, signal } from '@preact/signals-core';
import { type Reading, sameBytes } from '../modbus/index.ts';
import type { ByteNotation } from '../notation/index.ts';
import {
  type Draft,
  draftMeant,
  type Evaluation,
  type How,
  type InputMeaning,
  type ItemIdentity,
  type StaleReason,
  type TextReading,
} from '../workbench/index.ts';
import { same } from './steady.ts';

/** What of a draft makes its frame. */
const form = ({ transport, kind, texts, force }: Draft) => ({ transport, kind, texts, force });

/** The text to read as it stands, and what became of it. */
export type PastedText =
  | { readonly kind: 'empty' }
  /** The reader has not come yet; the text of a history's entry stands beside a frame and shows none (`kept`). */
  | { readonly kind: 'waiting'; readonly text: string; readonly how: How | 'kept' }
  | {
      readonly kind: 'read';
      readonly reading: TextReading;
      /** What the text was taken for. */
      readonly meaning: InputMeaning;
      /** The frame that stood here once it was read; `undefined` if it is one of those that the text may be. */
      readonly beside: Draft | undefined;
      /** The item whose frame was shown; −1 if none was. */
      readonly chosen: number;
    };

/** The page whose input it is. */
interface InputPage {
  readonly input: Signal<string>;
  readonly draft: ReadonlySignal<Draft>;
  readonly evaluation: ReadonlySignal<Evaluation>;
  /** The view that is open; `undefined` where frames are. */
  readonly view: ReadonlySignal<string | undefined>;
  readonly commit: () => void;
  /** The draft at the last step. */
  readonly stepped: () => Draft | undefined;
  readonly show: (next: Draft, how: How) => void;
  readonly showReading: (reading: Reading, request: Uint8Array | undefined, how: How, reply?: Uint8Array) => void;
  /** Lets the history follow the text of the input. */
  readonly typed: () => void;
}

/** What reads texts: it comes when there is a text. */
export interface Reader {
  readonly readText: (text: string, as: ByteNotation | undefined) => TextReading;
  readonly firstFrame: (reading: TextReading) => number;
  readonly identityOf: (reading: TextReading, index: number) => ItemIdentity | undefined;
  /** What a text means beside the frame that is there. */
  readonly meaningOf: (reading: TextReading, draft: Draft) => InputMeaning;
  /** Opens a text that is a log where logs are; `name` is that of the file which it was read from. */
  readonly openLog: (text: string, name: string | undefined) => void;
}

/** Longer texts, in characters, are logs, whatever is in them. */
const LONG = 50_000;
/** Whether a text is a log: it has more than one frame, and more than a request with a sound reply to it, which are shown as a pair. */
const isLog = ({ items: [, second, ...more] }: TextReading): boolean =>
  second !== undefined &&
  (more.length > 0 || second.kind !== 'frame' || second.answers !== 0 || second.severity === 'error');

/** The text that was pasted, what it was read as, and which of its frames is shown. */
export class Pasted {
  readonly state: Signal<PastedText> = signal({ kind: 'empty' });
  /** Whether the reader is to come. */
  readonly wanted = computed(() => this.state.value.kind === 'waiting');
  /** What the chosen item may be, and the request that it answers, or was to answer. */
  readonly identity = computed(() => {
    const { value } = this.state;
    return value.kind === 'read' ? this.#reader?.identityOf(value.reading, value.chosen) : undefined;
  });
  readonly #page: InputPage;
  #reader: Reader | undefined;
  /** The frame before the text was typed, and the one that it made. */
  #base: Draft | undefined;
  #made: Draft | undefined;
  /** The name of the file that the text was read from. */
  #name: string | undefined;
  /** The view from which the text came. */
  #from: string | undefined;
  /** Whether it was read while another view was open: the entry to which somebody comes back may be of before. */
  #waits = false;

  constructor(page: InputPage) {
    this.#page = page;
  }

  /** Brings what reads; a text that waits is read. */
  bring(reader: Reader): void {
    this.#reader = reader;
    const state = this.state.peek();
    if (state.kind !== 'waiting') return;
    const isLong = state.text.length > LONG;
    if (isLong) this.#read(this.#page.input.peek(), 'kept', undefined);
    else this.#read(state.text, state.how, undefined);
    if (isLong) reader.openLog(state.text, this.#name);
  }

  /** Takes the text of a history's entry, which stands beside the entry's frame. */
  restore(text: string): void {
    const state = this.state.peek();
    const isHere = text === this.#page.input.peek();
    if (isHere && state.kind === 'read' && this.#waits) this.#took(state.reading, 'edit');
    else if (isHere && state.kind === 'read') {
      this.state.value = { ...state, chosen: -1 };
      this.#rest();
    } else if (isHere && 'text' in state) {
      // Somebody comes back before the text has been read: it is shown here then.
      this.#from = undefined;
    } else {
      this.#page.input.value = text;
      this.#read(text, 'kept', undefined);
    }
  }

  /** Why a draft is not what the input says; `undefined` if it is, or was made after the text was read. */
  stale(draft: Draft): StaleReason | undefined {
    const { value } = this.state;
    if (value.kind !== 'read' || value.beside !== draft) return undefined;
    if (value.meaning.kind === 'no-bytes') return { code: 'no-bytes' };
    return value.meaning.kind === 'several' ? { code: 'not-chosen' } : undefined;
  }

  /** Reads a text that was pasted or dropped, or that a file of this name has; a blank one changes nothing. */
  readonly take = (text: string, name?: string): void => {
    if (text.trim() !== '') this.read(text, 'step', undefined, name);
  };

  /** Reads a text, or opens it as a log if it is long, which leaves what is here; `as` says in which notation, if the page's own choice was not meant. */
  readonly read = (text: string, how: How, as?: ByteNotation, name?: string): void => {
    // The same text, read another way, is that of the same file.
    this.#name = name ?? (text === this.#page.input.peek() ? this.#name : undefined);
    if (text.length > LONG) {
      if (this.#reader) this.#reader.openLog(text, name);
      else this.state.value = { kind: 'waiting', text, how };
      return;
    }
    if (how === 'step') this.#page.commit();
    // What is typed comes from the input, where frames are, though its pause may end elsewhere.
    this.#from = how === 'step' ? this.#page.view.peek() : undefined;
    this.#page.input.value = text;
    this.#page.typed();
    this.#read(text, how, as);
    if (how === 'step' && text.trim() === '') this.#page.commit();
  };

  #read(text: string, how: How | 'kept', as: ByteNotation | undefined): void {
    const reader = this.#reader;
    if (text.trim() === '') {
      this.state.value = { kind: 'empty' };
      const base = this.#baseFor(how);
      if (base !== this.#page.draft.peek()) this.#page.show(base, 'wait');
    } else if (reader === undefined) this.state.value = { kind: 'waiting', text, how };
    else this.#took(reader.readText(text, as), how);
  }

  /** Shows an item's frame: as a step, or in place while somebody goes through the list. */
  readonly choose = (index: number, how: How): void => {
    const state = this.state.peek();
    if (state.kind !== 'read' || state.reading.items[index] === undefined) return;
    this.state.value = { ...state, chosen: index };
    const found = this.identity.peek();
    const [best] = found?.identities ?? [];
    if (best) this.#page.showReading(best.reading, found?.request, how, found?.reply);
  };

  /** What is known of bytes from the text that they were read from; `undefined` if they are not the chosen item's. */
  itemWith(bytes: Uint8Array): ItemIdentity | undefined {
    const found = this.identity.value;
    return found && sameBytes(found.bytes, bytes) ? found : undefined;
  }

  #took(reading: TextReading, how: How | 'kept'): void {
    const reader = this.#reader as Reader;
    const { draft } = this.#page;
    const base = this.#baseFor(how);
    const meaning = reader.meaningOf(reading, base);
    this.state.value = { kind: 'read', reading, meaning, beside: undefined, chosen: -1 };
    if (how !== 'kept') {
      const meant = draftMeant(meaning);
      // Who went to another view meanwhile stays there.
      this.#waits = this.#page.view.peek() !== this.#from;
      const here = this.#waits ? 'wait' : 'edit';
      if (meaning.kind === 'frames') this.choose(reader.firstFrame(reading), here);
      else if (meant ?? base !== draft.peek()) this.#page.show(meant ?? base, here);
      this.#made = draft.peek();
      if (how === 'step') this.#page.commit();
    }
    this.#rest();
    if (how === 'step' && isLog(reading) && !this.#waits) reader.openLog(reading.text, this.#name);
  }

  /** The frame beside which a text is read: that of the last step, while what was typed since stands in its place. */
  #baseFor(how: How | 'kept'): Draft {
    const current = this.#page.draft.peek();
    const typing = how === 'edit' && current === this.#made && current !== this.#page.stepped();
    if (!typing || this.#base === undefined) this.#base = current;
    return this.#base;
  }

  /** Finds the item whose frame is shown, and whether the frame is another one than the text says. */
  #rest(): void {
    const state = this.state.peek();
    if (state.kind !== 'read') return;
    const [draft, { frame }] = [this.#page.draft.peek(), this.#page.evaluation.peek()];
    const { items, bytes } = state.reading;
    const { meaning } = state;
    const chosen = items.findIndex(({ from, to }) => frame && sameBytes(bytes.subarray(from, to), frame.bytes));
    const taken = meaning.kind === 'several' && meaning.offers.some((offer) => same(form(offer.draft), form(draft)));
    this.state.value = {
      ...state,
      beside: taken ? undefined : draft,
      chosen: meaning.kind !== 'frames' ? -1 : state.chosen < 0 ? chosen : state.chosen,
    };
  }
}
