import {
  choosePort,
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
  makeClock,
  noErrors,
  type OutputSignals,
  portsLike,
  type Refusal,
  type SentResult,
  Session,
  type SessionCommand,
  type SessionNews,
  serialSupport,
  type TransactionRules,
  WebSerialLink,
} from '../../bus/index.ts';
import { busStatus } from '../bus-status.ts';
import { type Running, startWorker, type WorkerEnd } from '../start-worker.ts';
import { busWords } from './language.ts';
import { rulesMemory, settingsMemory } from './memories.ts';

/** Somebody is asked whether requests are to be sent. */
export interface Question {
  /** What is done when the answer is yes. */
  readonly command: Extract<SessionCommand, { readonly confirmed: boolean }>;
  readonly why: Doubt;
}

/** Who started a job is told what it has to tell. */
export interface JobListener {
  news(news: readonly JobNews[]): void;
  /** It has ended, or was not begun: `refused` by the guard, or somebody said no. `lost` is the session that had it. */
  ended(why: 'ended' | 'refused' | 'declined' | 'lost'): void;
}

export interface BusState {
  readonly link: LinkState;
  readonly settings: LinkSettings;
  readonly rules: TransactionRules;
  readonly errors: LineErrorCounts;
  /** `undefined` until they were asked for, and where the adapter has none. */
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

/**
 * The bus as the window knows it. The session works in a worker; what it tells is taken over here, and those who show it
 * are told. It holds nothing that is drawn with the rest of the page, so that a busy line does not draw all of it.
 */
class Bus {
  readonly #listeners = new Listeners<BusState>();
  /** All that the session tells, for those who take more of it than stands in the state. */
  readonly news = new Listeners<SessionNews>();
  #post: ((command: SessionCommand) => void) | undefined;
  #worker: Running<SessionCommand> | undefined;
  #count = 0;
  readonly #jobs = new Map<number, JobListener>();
  state: BusState = {
    link: serialSupport(window) ?? { kind: 'closed' },
    settings: settingsMemory.value,
    rules: rulesMemory.value,
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

  /** Answers how to stop listening. */
  listen(listener: (state: BusState) => void): () => void {
    return this.#listeners.add(listener);
  }

  set(change: Partial<BusState>): void {
    this.state = { ...this.state, ...change };
    if (change.link) busStatus.value = busWords.linkShort(change.link);
    this.#listeners.tell(this.state);
  }

  /** Lets the person choose a port, and opens it. */
  async connect(): Promise<void> {
    this.set({ link: { kind: 'choosing' } });
    const choice = await choosePort(navigator.serial);
    if (choice.kind === 'refused') this.set({ link: choice });
    else await this.openPort(choice.port);
  }

  /** Opens a port that was chosen before. */
  async openPort(port: SerialPort): Promise<void> {
    const info = port.getInfo();
    const twins = await portsLike(navigator.serial, info);
    this.#host(twins.length > 1 ? port : undefined);
    this.#do({ kind: 'open-port', port: info, settings: this.state.settings });
  }

  /** Gives commands to the session in the worker, which begins where there is none. */
  host(commands: readonly SessionCommand[]): void {
    this.#host(undefined);
    for (const command of commands) this.#do(command);
  }

  /** Gives a command to the session, if there is one. */
  command(command: SessionCommand): void {
    this.#do(command);
  }

  close(): void {
    this.#do({ kind: 'close' });
  }

  setSettings(settings: LinkSettings): void {
    settingsMemory.value = settings;
    this.set({ settings });
  }

  setRules(rules: TransactionRules): void {
    rulesMemory.value = rules;
    this.set({ rules });
    this.#do({ kind: 'set-rules', rules });
  }

  setReadOnly(readOnly: boolean): void {
    this.set({ readOnly, refused: undefined });
    this.#do({ kind: 'set-read-only', readOnly });
  }

  setSignals(signals: OutputSignals): void {
    this.#do({ kind: 'set-signals', signals });
  }

  /** Sends a request, once the guard has nothing against it; one that is being sent already is not sent twice. */
  send(request: Uint8Array, transport: TransactionRules['transport']): void {
    if (this.state.sending.size > 0) return;
    // While the virtual devices answer, the mode is theirs.
    if (!this.state.serving && this.state.rules.transport !== transport)
      this.setRules({ ...this.state.rules, transport });
    this.#sendAs({ kind: 'send', id: this.#next(), request, confirmed: false });
  }

  /** Begins a job; answers its number. */
  startJob(order: JobOrder, listener: JobListener): number {
    const id = this.#next();
    this.#jobs.set(id, listener);
    if (this.#post) this.#do({ kind: 'start-job', id, order, confirmed: false });
    else this.#jobEnded(id, 'lost');
    return id;
  }

  stopJob(id: number): void {
    this.#do({ kind: 'stop-job', id });
  }

  /** Answers the question that stands. */
  answer(yes: boolean): void {
    const { question } = this.state;
    this.set({ question: undefined });
    if (question === undefined) return;
    const { command } = question;
    if (!yes) this.#jobEnded(command.id, 'declined');
    else if (command.kind === 'send') this.#sendAs(command);
    else this.#do(command);
  }

  /** Ends all that goes on. */
  stop(): void {
    this.#do({ kind: 'stop' });
  }

  clearLog(): void {
    this.set({ cleared: this.state.log, log: [] });
  }

  /** Shows a log that was saved, in place of the one there is. */
  openLog(lines: readonly LogLine[]): void {
    this.set({ cleared: this.state.log, log: lines });
  }

  bringLogBack(): void {
    this.set({ log: this.state.cleared ?? [], cleared: undefined });
  }

  #sendAs(command: Extract<SessionCommand, { readonly kind: 'send' }>): void {
    this.set({ sending: new Map(this.state.sending).set(command.id, command.request), refused: undefined });
    this.#do(command);
  }

  #next(): number {
    this.#count += 1;
    return this.#count;
  }

  #jobEnded(id: number, why: Parameters<JobListener['ended']>[0]): void {
    const listener = this.#jobs.get(id);
    this.#jobs.delete(id);
    listener?.ended(why);
  }

  #do(command: SessionCommand): void {
    this.#post?.(command);
  }

  /** Where the session works: in a worker, or here for a port that a worker could not tell from another. */
  #host(port: SerialPort | undefined): void {
    const inWindow = port !== undefined;
    if (this.#post !== undefined && !inWindow && !this.state.inWindow) return;
    this.#do({ kind: 'close' });
    this.#worker?.end();
    this.#drop();
    if (port) {
      const clock = makeClock();
      const session = new Session({
        clock,
        portLink: () => Promise.resolve(new WebSerialLink(port, clock)),
        tell: (news) => this.#take(news),
      });
      this.#post = (command) => void session.take(command);
    } else {
      const worker = startWorker<SessionCommand, SessionNews>('session', (news) => this.#take(news), this.#ended);
      this.#worker = worker;
      this.#post = (command) => worker.post(command);
    }
    this.set({ inWindow });
    this.#do({ kind: 'set-rules', rules: this.state.rules });
    this.#do({ kind: 'set-read-only', readOnly: this.state.readOnly });
  }

  /** The worker has ended without being told to: the next that connects makes another. */
  readonly #ended = (why: WorkerEnd): void => {
    this.set({ link: { kind: 'no-session', why } });
    this.#drop();
  };

  /** A session that is gone says nothing more of what it was to do. */
  #drop(): void {
    this.#worker = undefined;
    this.#post = undefined;
    this.set({ sending: new Map(), question: undefined, serving: false, signals: undefined });
    for (const id of this.#jobs.keys()) this.#jobEnded(id, 'lost');
  }

  #take(news: SessionNews): void {
    this.news.tell(news);
    switch (news.kind) {
      case 'state':
        this.set({ link: news.state, ...(news.state.kind === 'open' && { signals: undefined, signalsTaken: true }) });
        break;
      case 'signals':
        this.set({ signals: news.signals, signalsTaken: news.set });
        break;
      case 'lines': {
        const log = [...this.state.log, ...news.lines];
        this.set({ log: log.length > MOST_LINES ? log.slice(log.length - MOST_LINES) : log, cleared: undefined });
        break;
      }
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
        this.#jobEnded(news.id, 'refused');
        break;
      case 'jobs':
        for (const [id, listener] of this.#jobs) {
          const own = news.news.filter((one) => one.id === id).map((one) => one.news);
          if (own.length > 0) listener.news(own);
        }
        break;
      case 'serving':
        this.set({ serving: news.on, refused: undefined });
        break;
      case 'job-ended':
        this.#jobEnded(news.id, 'ended');
        break;
    }
  }

  #without(id: number): BusState['sending'] {
    return new Map([...this.state.sending].filter(([other]) => other !== id));
  }
}

export const bus = new Bus();
