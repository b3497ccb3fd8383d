import { batch, computed, type Signal, signal } from '@preact/signals-core';
import { type Reading, type SerialLine, sameBytes } from '../modbus/index.ts';
import {
  type AddressContext,
  type AddressReading,
  type Draft,
  type DraftedFrame,
  draftOf,
  evaluate,
  type FrameTab,
  fieldFault,
  firstAddressContext,
  firstContext,
  firstDraft,
  type HistoryEntry,
  type How,
  type InputMeaning,
  type InputOffer,
  isSoundRequest,
  type LinkReading,
  type OpenReading,
  openReadings,
  type Pair,
  pairOf,
  parted,
  readInFull,
  readLink,
  replyOfPair,
  replyTo,
  requestOfPair,
  type ShownFrame,
  settled,
  showPlan,
  stepPlan,
  withKind,
  withReply,
  writeLink,
} from '../workbench/index.ts';
import { Address, type AddressBar, type After } from './address.ts';
import { Pasted } from './pasted.ts';
import { steady } from './steady.ts';
import { addressOf, type OtherView, type ViewParts, viewAt } from './views.ts';

/** An address that could not be read in full, and what was read. */
export interface BrokenAddress {
  readonly hash: string;
  readonly reading: LinkReading;
}

/** What the text of the input was taken for, or that it is not read yet. */
export type Meant = InputMeaning | { readonly kind: 'waiting' };

/** The frame as typed, from which everything shown follows, the view that is open, and the address that has both. */
export class Page {
  readonly address: Address;
  readonly draft: Signal<Draft> = signal(firstDraft);
  /** What the draft comes to, worked out once for each draft. */
  readonly evaluation = computed(() => evaluate(this.draft.value));
  /** The tab that is open beside the form. */
  readonly tab: Signal<FrameTab> = signal(firstContext.tab);
  /** The line that the frame's link names; `undefined` if it names none. */
  readonly line: Signal<SerialLine | undefined> = signal(firstContext.line);
  /** The id of the device that is chosen; `Devices` keeps it. */
  readonly device: Signal<string | undefined> = signal(undefined);
  /** The text of a device that a link brought here and that is chosen: links have it inside them. */
  readonly profile: Signal<string | undefined> = signal(undefined);
  /** The target and the part of the program that the tab shows, as a text. */
  readonly program: Signal<string | undefined> = signal(undefined);
  /** The link to the draft, without `#`. */
  readonly link = computed(() =>
    writeLink(this.draft.value, this.evaluation.value.controls, {
      tab: this.tab.value,
      line: this.line.value,
      device: this.device.value,
      profile: this.profile.value,
      program: this.tab.value === 'program' ? this.program.value : undefined,
    }),
  );
  /** Makes the page's own link one for others: `Devices` puts a person's own device into it. */
  readonly shared: Signal<(href: string) => string> = signal(String);
  /** Whether links lack the chosen device, which has more registers than a link can hold. */
  readonly leavesOut = signal(false);
  /** The link to the frame, with the device that names what is in it and nothing else beside it. */
  readonly frameLink = computed(() =>
    writeLink(this.draft.value, this.evaluation.value.controls, { ...firstContext, device: this.device.value }),
  );
  readonly transport = computed(() => this.draft.value.transport);
  readonly kind = computed(() => this.draft.value.kind);
  readonly brokenLink: Signal<BrokenAddress | undefined> = signal(undefined);
  /** The view that is open; `undefined` is the Frame view, where the draft waits meanwhile. */
  readonly view: Signal<OtherView | undefined> = signal(undefined);
  /** The text of the one input. It is changed by `takeInput`. */
  readonly input: Signal<string> = signal('');
  /** What reads the text of the input. */
  readonly pasted = new Pasted(this);
  /** What the text of the input was taken for. */
  readonly meant = computed((): Meant => {
    const { value } = this.pasted.state;
    return value.kind === 'read' ? value.meaning : { kind: value.kind };
  });
  /** The frame that is shown: the current one, or the last there was, and why that is not current. */
  readonly shown = computed((): ShownFrame => {
    const [draft, evaluation] = [this.draft.value, this.evaluation.value];
    const fault = fieldFault(evaluation);
    if (fault === undefined) return { draft, frame: evaluation.frame, stale: this.pasted.stale(draft) };
    return { ...(this.#good ?? { draft, frame: undefined }), stale: fault };
  });
  /** The request and the reply that the frame is one of. */
  readonly pair = computed((): Pair | undefined => pairOf(this.draft.value, this.evaluation.value.frame));
  /** What gives typed addresses their meaning; `Addresses` keeps it. */
  readonly addressing: Signal<AddressContext> = signal(firstAddressContext);
  /** The addresses that may be a manual's number or an address, while nobody has said which. */
  readonly openReadings = steady(() => openReadings(this.draft.value, this.evaluation.value, this.addressing.value));
  /** The last draft that had a frame, if the draft has none. */
  #good: Pick<ShownFrame, 'draft' | 'frame'> | undefined;
  /** The draft at the last step. */
  #stepped: Draft | undefined;
  /** The last request that stood here and was sound. */
  #asked: DraftedFrame | undefined;
  /** Whether somebody made the draft here: by the form, or by choosing. */
  #byHand = false;

  constructor(bar: AddressBar, after: After) {
    this.address = new Address(bar, after);
    this.address.given.subscribe(({ hash, input }) => batch(() => this.#take(hash, input)));
  }

  /** Changes the draft while something is typed: the address follows in place, but not where another view has it. */
  readonly edit = (next: Draft): void => {
    batch(() => {
      this.#become(next);
      this.brokenLink.value = undefined;
    });
    this.#byHand = true;
    this.typed();
  };

  /** Ends the typing of a field: what was typed becomes a step, and Back returns to what stood before it. */
  readonly commit = (): void => {
    // A field that is left because its view is left ends no step.
    if (this.view.peek() !== undefined) return;
    this.#remember();
    const entry = this.#entry();
    // What stands beside the frame, such as its tab, makes no step.
    if (this.#isStepped) this.address.now();
    else this.address.step(stepPlan(entry, this.address.stepped, false), entry);
    this.#stepped = this.draft.peek();
  };

  /** The draft at the last step. */
  readonly stepped = (): Draft | undefined => this.#stepped;

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
  readonly open = (view: OtherView | undefined, parts: ViewParts = {}): void =>
    this.address.go(view === undefined ? this.#entry() : viewEntry(addressOf(view, parts)));

  /** Opens a tab beside the form. */
  readonly openTab = (tab: FrameTab): void => {
    this.tab.value = tab;
    this.besideChanged();
  };

  /** Sets the line that the frame's link names. */
  readonly setLine = (line: SerialLine): void => {
    this.line.value = line;
    this.besideChanged();
  };

  /** Lets the address follow what stands beside the frame, in place. */
  readonly besideChanged = (): void => {
    if (this.view.peek() === undefined) this.address.later(this.#entry, this.#isStepped);
  };

  /** Takes the text of the input: while it is typed in place, else as a step. A blank text leaves the frame as it is. */
  readonly takeInput = (text: string, how: How = 'edit'): void => this.pasted.read(text, how);

  /** Lets the history follow the text of the input. */
  readonly typed = (): void => {
    if (this.view.peek() === undefined) this.address.later(this.#entry, false);
  };

  /** Takes one of the things that the text of the input may be. */
  readonly choose = (offer: InputOffer): void => this.step(offer.draft);

  /**
   * Shows bytes as they were read. A reply is joined to the request that it is said to answer, or else to the one that stood
   * here, if it answers it; a request to its `reply`, if that is known.
   */
  readonly showReading = (
    reading: Reading,
    request: Uint8Array | undefined,
    how: How,
    reply?: Uint8Array | undefined,
  ): void => {
    const next = this.#joined(reading, request);
    this.show(reply ? withReply(next, reply) : next, how);
    this.#byHand = false;
  };

  /** Parts the frame from the other one of its pair. */
  readonly part = (): void => this.step(parted(this.draft.peek()));

  /** Makes the frame one of another kind; the other frame of its pair comes with all that was typed for it. */
  readonly chooseKind = (kind: Draft['kind']): void => this.step(withKind(this.draft.peek(), kind, this.pair.peek()));

  /** Shows the request of the pair, with all that was typed for it. */
  readonly toRequest = (): void => this.#toOther('reply', requestOfPair);

  /** Shows the reply of the pair. */
  readonly toReply = (): void => this.#toOther('request', replyOfPair);

  /** Both readings of the address at a path; `undefined` unless it is open. */
  readonly openReading = (path: string): OpenReading | undefined =>
    this.openReadings.value.find((open) => open.path === path);

  /** Takes an open address for one of its readings. */
  readonly settle = (path: string, which: AddressReading): void => {
    const open = this.openReadings.peek().find((one) => one.path === path);
    if (open) this.step(settled(this.draft.peek(), open, which));
  };

  /** Lets the address follow what is typed in a view; `parts` is asked at a pause. */
  readonly follow = (view: OtherView, parts: () => ViewParts): void =>
    this.address.later(() => viewEntry(addressOf(view, parts())), true);

  /** Takes the frame that the address of another view names; an empty text names none. */
  readonly takeFrame = (link: string): void => {
    const read = link === this.frameLink.peek() ? undefined : readLink(link);
    if (read === undefined) return;
    batch(() => {
      this.#become(read.draft);
      this.brokenLink.value = undefined;
    });
  };

  /** Whether neither the frame nor the input has changed since the last step. */
  get #isStepped(): boolean {
    return this.draft.peek() === this.#stepped && this.input.peek() === this.address.stepped.input;
  }

  readonly #entry = (): HistoryEntry => {
    // The page that nobody has touched has no address of its own.
    const untouched =
      this.draft.peek() === firstDraft && this.tab.peek() === 'bytes' && this.address.stepped.hash === '';
    return { hash: untouched ? '' : `#${this.link.peek()}`, input: this.input.peek() };
  };

  #become(next: Draft): void {
    const { frame } = this.evaluation.peek();
    if (frame) this.#good = { draft: this.draft.peek(), frame };
    this.draft.value = next;
  }

  #joined(reading: Reading, request: Uint8Array | undefined): Draft {
    this.#remember();
    const next = draftOf(reading, reading.direction === 'response' ? request : undefined);
    const bytes = evaluate(next).frame?.bytes;
    if (bytes === undefined) return next;
    for (const asked of [this.pair.peek()?.request, this.#asked]) {
      // What says the same once more is the same request, unless it was built here or the text says that this is a reply.
      const again = asked !== undefined && saysTheSame(asked, bytes);
      if (asked === undefined || (again && !this.#byHand && reading.direction === 'request')) continue;
      const reply = asked.draft.transport === next.transport ? replyTo(asked, bytes) : undefined;
      if (reply !== undefined && (request === undefined || reply.answering === next.answering)) return reply;
    }
    return next;
  }

  /** Remembers the request that stands here: what comes next may answer it. */
  #remember(): void {
    const [draft, { frame }] = [this.draft.peek(), this.evaluation.peek()];
    if (frame && draft.kind === 'request' && isSoundRequest(frame.reading)) this.#asked = { draft, ...frame };
  }

  #toOther(from: 'request' | 'reply', to: (pair: Pair) => Draft): void {
    const pair = this.pair.peek();
    const isRequest = this.draft.peek().kind === 'request';
    if (pair && isRequest === (from === 'request')) this.step(to(pair));
  }

  #take(hash: string, input: string | undefined): void {
    this.view.value = viewAt(hash);
    if (this.view.value !== undefined) return;
    const read = readLink(hash);
    // A link within the page to the frame that is here leaves the input as it is.
    const here = hash === `#${this.link.peek()}` ? this.input.peek() : '';
    const text = input ?? read?.draft.bytes ?? here;
    this.#become(read?.draft ?? firstDraft);
    const { tab, line, profile, program } = read?.context ?? firstContext;
    if (profile) this.profile.value = profile;
    if (program) this.program.value = program;
    this.tab.value = tab;
    this.line.value = line;
    this.#byHand = false;
    this.#stepped = this.draft.peek();
    this.brokenLink.value = read && !readInFull(read) ? { hash, reading: read } : undefined;
    this.#remember();
    this.pasted.restore(text);
  }
}

/** Whether bytes are those of a frame but for its checksum, which may be a wrong one. */
function saysTheSame({ bytes, reading }: DraftedFrame, other: Uint8Array): boolean {
  const end = reading.spans.find(({ kind }) => kind === 'checksum')?.from ?? bytes.length;
  return bytes.length === other.length && sameBytes(bytes.subarray(0, end), other.subarray(0, end));
}

const viewEntry = (hash: string): HistoryEntry => ({ hash, input: '' });
