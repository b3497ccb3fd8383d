import { batch, computed, type Signal, signal } from '@preact/signals-core';
import type { Reading } from '../modbus/index.ts';
import {
  type Draft,
  draftOf,
  evaluate,
  firstDraft,
  type How,
  type LinkReading,
  readInFull,
  readLink,
  showPlan,
  stepPlan,
  writeLink,
} from '../workbench/index.ts';
import { Address, type AddressBar, type After } from './address.ts';
import { addressOf, type OtherView, type ViewParts, viewAt } from './views.ts';

/** An address that could not be read in full, and what was read. */
export interface BrokenAddress {
  readonly hash: string;
  readonly reading: LinkReading;
}

/** The frame as typed, from which everything shown follows, the view that is open, and the address that has both. */
export class Page {
  readonly address: Address;
  readonly draft: Signal<Draft> = signal(firstDraft);
  /** What the draft comes to, worked out once for each draft. */
  readonly evaluation = computed(() => evaluate(this.draft.value));
  /** The link to the draft, without `#`. */
  readonly link = computed(() => writeLink(this.draft.value, this.evaluation.value.controls));
  readonly transport = computed(() => this.draft.value.transport);
  readonly kind = computed(() => this.draft.value.kind);
  readonly brokenLink: Signal<BrokenAddress | undefined> = signal(undefined);
  /** The view that is open; `undefined` is the Frame view, where the draft waits meanwhile. */
  readonly view: Signal<OtherView | undefined> = signal(undefined);

  constructor(bar: AddressBar, after: After) {
    this.address = new Address(bar, after);
    this.address.given.subscribe(({ hash }) => batch(() => this.#take(hash)));
  }

  /** Changes the draft while something is typed: the address follows in place. */
  readonly edit = (next: Draft): void => {
    batch(() => {
      this.draft.value = next;
      this.brokenLink.value = undefined;
    });
    this.address.later(this.#hash, false);
  };

  /** Ends the typing of a field: what was typed becomes a step, and Back returns to what stood before it. */
  readonly commit = (): void => {
    // A field that is left because its view is left ends no step.
    if (this.view.peek() !== undefined) return;
    const hash = this.#hash();
    this.address.step(stepPlan(hash, this.address.stepped, false), hash);
  };

  /** Changes the draft by a step of its own. */
  readonly step = (next: Draft): void => {
    this.commit();
    this.edit(next);
    this.commit();
  };

  /** Shows a frame; from another view, where frames are. */
  readonly show = (next: Draft, how: How): void => {
    const elsewhere = this.view.peek() !== undefined;
    if (elsewhere) this.address.now();
    for (const act of showPlan(how, elsewhere)) {
      if (act === 'close-view') this.view.value = undefined;
      else if (act === 'edit') this.edit(next);
      else this.commit();
    }
  };

  /** Opens a view; `undefined` is the Frame view with the current frame. */
  readonly open = (view: OtherView | undefined): void =>
    this.address.go(view === undefined ? this.#hash() : `#${view}`);

  /** Shows bytes as they were read; a reply with the request that it answers. */
  readonly showReading = (reading: Reading, request: Uint8Array | undefined, how: How): void =>
    this.show(draftOf(reading, reading.direction === 'response' ? request : undefined), how);

  /** Lets the address follow what is typed in a view; `parts` is asked at a pause. */
  readonly follow = (view: OtherView, parts: () => ViewParts): void =>
    this.address.later(() => addressOf(view, parts()), true);

  /** Takes the frame that the address of another view names; an empty text names none. */
  readonly takeFrame = (link: string): void => {
    const read = link === this.link.peek() ? undefined : readLink(link);
    if (read === undefined) return;
    batch(() => {
      this.draft.value = read.draft;
      this.brokenLink.value = undefined;
    });
  };

  readonly #hash = () => `#${this.link.peek()}`;

  #take(hash: string): void {
    this.view.value = viewAt(hash);
    if (this.view.value !== undefined) return;
    const read = readLink(hash);
    this.draft.value = read?.draft ?? firstDraft;
    this.brokenLink.value = read && !readInFull(read) ? { hash, reading: read } : undefined;
  }
}
