import {
  type Doubt,
  type InputSignals,
  type JobNews,
  type JobOrder,
  type LineErrorCounts,
  type LinkSettings,
  type LinkState,
  Listeners,
  type LogLine,
  MOST_LINES,
  noErrors,
  type OutputSignals,
  type Refusal,
  type SentResult,
  type SessionCommand,
  type SessionNews,
  type TransactionRules,
} from '../../bus/index.ts';

/** Somebody is asked whether requests are to be sent. */
export interface Question {
  /** What is done if the answer is yes. */
  readonly command: Extract<SessionCommand, { readonly confirmed: boolean }>;
  readonly why: Doubt;
}

/**
 * Why a job is over, or was not begun. `stopped`: it has ended, by itself or because it was stopped. `lost`: the adapter was
 * lost. `disconnected`: the connection was closed, or the session is gone. `declined`: somebody was asked, and said no.
 */
export type JobEnd =
  | { readonly kind: 'stopped' | 'lost' | 'disconnected' | 'declined' }
  | { readonly kind: 'refused'; readonly why: Refusal };

/** Who began a job is told what it finds, and once how it has ended. */
export interface JobFollower {
  news(news: readonly JobNews[]): void;
  ended(end: JobEnd): void;
}

export interface BusState {
  readonly link: LinkState;
  readonly settings: LinkSettings;
  readonly rules: TransactionRules;
  readonly errors: LineErrorCounts;
  /** `undefined` until they were asked for, or if the adapter has none. */
  readonly signals: InputSignals | undefined;
  /** Whether the adapter took the signals that were set last. */
  readonly signalsTaken: boolean;
  readonly readOnly: boolean;
  /** Requests that have not ended, by their number. */
  readonly sending: ReadonlyMap<number, Uint8Array>;
  readonly question: Question | undefined;
  /** Why the last request was not sent. */
  readonly refused: Refusal | undefined;
  /** Whether the virtual devices answer what arrives on the port; nothing is sent meanwhile. */
  readonly serving: boolean;
  /** What became of the last request. */
  readonly last: SentResult | undefined;
  readonly log: readonly LogLine[];
  /** Lines that were cleared, until others come. */
  readonly cleared: readonly LogLine[] | undefined;
  /** Adapters of one kind cannot be told apart in a worker: this session works in the window. */
  readonly inWindow: boolean;
}

interface KnownJob {
  readonly follower: JobFollower;
  /** Somebody has stopped it, so that it does not end because its line was closed. */
  readonly stopped: boolean;
}

/** A session as a window knows it: what it has told, and the commands that it is given. */
export class SessionView {
  readonly #listeners = new Listeners<BusState>();
  /** All that the session tells, for those who need more of it than the state holds. */
  readonly news = new Listeners<SessionNews>();
  #post: ((command: SessionCommand) => void) | undefined;
  #count = 0;
  readonly #jobs = new Map<number, KnownJob>();
  state: BusState;

  constructor(known: Pick<BusState, 'link' | 'settings' | 'rules'>) {
    this.state = {
      ...known,
      errors: noErrors,
      signals: undefined,
      signalsTaken: true,
      readOnly: true,
      sending: new Map(),
      question: undefined,
      refused: undefined,
      serving: false,
      last: undefined,
      log: [],
      cleared: undefined,
      inWindow: false,
    };
  }

  /** Answers how to stop listening. */
  listen(listener: (state: BusState) => void): () => void {
    return this.#listeners.add(listener);
  }

  set(change: Partial<BusState>): void {
    this.state = { ...this.state, ...change };
    this.#listeners.tell(this.state);
  }

  get hasSession(): boolean {
    return this.#post !== undefined;
  }

  /** From now on commands go to this session, which is told what it has to know first. */
  attach(post: (command: SessionCommand) => void): void {
    this.#post = post;
    this.command({ kind: 'set-rules', rules: this.state.rules });
    this.command({ kind: 'set-read-only', readOnly: this.state.readOnly });
  }

  /** The session is gone: it says nothing more of what it was to do. */
  drop(): void {
    this.#post = undefined;
    this.set({ sending: new Map(), question: undefined, serving: false, signals: undefined });
    for (const id of [...this.#jobs.keys()]) this.#jobEnded(id, { kind: this.#endOfLine });
  }

  /** Gives a command to the session, if there is one. */
  command(command: SessionCommand): void {
    this.#post?.(command);
  }

  close(): void {
    this.command({ kind: 'close' });
  }

  setRules(rules: TransactionRules): void {
    this.set({ rules });
    this.command({ kind: 'set-rules', rules });
  }

  setReadOnly(readOnly: boolean): void {
    this.set({ readOnly, refused: undefined });
    this.command({ kind: 'set-read-only', readOnly });
  }

  setSignals(signals: OutputSignals): void {
    this.command({ kind: 'set-signals', signals });
  }

  /** Sends a request if the guard allows it. While one is being sent, another is not. */
  send(request: Uint8Array, transport: TransactionRules['transport']): void {
    if (this.state.sending.size > 0) return;
    // While the virtual devices answer, the mode is theirs.
    if (!this.state.serving) this.#setTransport(transport);
    this.#sendAs({ kind: 'send', id: this.#next(), request, confirmed: false });
  }

  /** Begins a job, in this mode if it needs one; answers how to stop it. A sequence can be stopped twice. */
  startJob(order: JobOrder, follower: JobFollower, transport?: TransactionRules['transport']): () => void {
    const id = this.#next();
    this.#jobs.set(id, { follower, stopped: false });
    if (transport !== undefined) this.#setTransport(transport);
    if (this.hasSession) this.command({ kind: 'start-job', id, order, confirmed: false });
    else this.#jobEnded(id, { kind: this.#endOfLine });
    return () => {
      if (!this.#jobs.has(id)) return;
      this.#jobs.set(id, { follower, stopped: true });
      this.command({ kind: 'stop-job', id });
    };
  }

  /** Answers the question that was asked. */
  answer(yes: boolean): void {
    const { question } = this.state;
    this.set({ question: undefined });
    if (question === undefined) return;
    const { command } = question;
    if (!yes) this.#jobEnded(command.id, { kind: 'declined' });
    else if (command.kind === 'send') this.#sendAs(command);
    else this.command(command);
  }

  /** Ends all that is going on. */
  stop(): void {
    this.command({ kind: 'stop' });
  }

  clearLog(): void {
    this.set({ cleared: this.state.log, log: [] });
  }

  /** Shows a log that was saved in place of this one. */
  openLog(lines: readonly LogLine[]): void {
    this.set({ cleared: this.state.log, log: lines });
  }

  bringLogBack(): void {
    this.set({ log: this.state.cleared ?? [], cleared: undefined });
  }

  /** Takes what the session tells. */
  take(news: SessionNews): void {
    this.news.tell(news);
    switch (news.kind) {
      case 'state':
        this.set({ link: news.state, ...(news.state.kind === 'open' && { signals: undefined, signalsTaken: true }) });
        break;
      case 'signals':
        this.set({ signals: news.signals, signalsTaken: news.set });
        break;
      case 'lines':
        this.set({ log: withLines(this.state.log, news.lines), cleared: undefined });
        break;
      case 'errors':
        this.set({ errors: news.errors });
        break;
      case 'result':
        this.set({ sending: this.#without(news.id), last: news.result });
        break;
      case 'ask':
        this.set({
          sending: this.#without(news.id),
          question: { command: { kind: 'send', id: news.id, request: news.request, confirmed: true }, why: news.why },
        });
        break;
      case 'ask-job': {
        const { id, order, why } = news;
        this.set({ question: { command: { kind: 'start-job', id, order, confirmed: true }, why } });
        break;
      }
      case 'refused':
        this.set({ sending: this.#without(news.id), refused: news.why });
        this.#jobEnded(news.id, { kind: 'refused', why: news.why });
        break;
      case 'jobs':
        for (const [id, { follower }] of this.#jobs) {
          const own = news.news.filter((one) => one.id === id).map((one) => one.news);
          if (own.length > 0) follower.news(own);
        }
        break;
      case 'serving':
        this.set({ serving: news.on, refused: undefined });
        break;
      case 'job-ended': {
        const { kind } = this.state.link;
        const byItself = kind === 'open' || (kind !== 'lost' && this.#jobs.get(news.id)?.stopped);
        this.#jobEnded(news.id, { kind: byItself ? 'stopped' : this.#endOfLine });
        break;
      }
    }
  }

  /** How a job ends that has no line any more. */
  get #endOfLine(): 'lost' | 'disconnected' {
    return this.state.link.kind === 'lost' ? 'lost' : 'disconnected';
  }

  #setTransport(transport: TransactionRules['transport']): void {
    if (this.state.rules.transport !== transport) this.setRules({ ...this.state.rules, transport });
  }

  #sendAs(command: Extract<SessionCommand, { readonly kind: 'send' }>): void {
    this.set({ sending: new Map(this.state.sending).set(command.id, command.request), refused: undefined });
    this.command(command);
  }

  #next(): number {
    this.#count += 1;
    return this.#count;
  }

  #jobEnded(id: number, end: JobEnd): void {
    const job = this.#jobs.get(id);
    this.#jobs.delete(id);
    job?.follower.ended(end);
  }

  #without(id: number): BusState['sending'] {
    return new Map([...this.state.sending].filter(([other]) => other !== id));
  }
}

/** The last lines of a log to which some are added; each list is another, so that a view sees that it has changed. */
function withLines(log: readonly LogLine[], lines: readonly LogLine[]): readonly LogLine[] {
  const over = log.length + lines.length - MOST_LINES;
  return over > 0 ? log.slice(over).concat(lines.slice(-MOST_LINES)) : log.concat(lines);
}
