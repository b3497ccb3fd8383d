import { batch, computed, effect, type ReadonlySignal, type Signal, signal } from '@preact/signals-core';
import {
  choosePort,
  defaultRules,
  type InputSignals,
  type JobOrder,
  type LinkSettings,
  type LinkState,
  noErrors,
  type OutputSignals,
  type Port,
  type SessionNews,
  type TransactionRules,
} from '../bus/index.ts';
import { type Pace, readPace, readRules } from '../workbench/index.ts';
import { BusJobs, type JobKind, type JobState, type TakeNews } from './bus-jobs.ts';
import { BusLog, type LogTrace } from './bus-log.ts';
import type { Line } from './line.ts';
import { portSettings } from './port-settings.ts';
import { type Question, SentRequests } from './sent-requests.ts';
import { type HostParts, SessionHost } from './session-host.ts';
import { KeptChoice, type PageStorage } from './storage.ts';
import { VirtualDevices } from './virtual-devices.ts';

/** What a window has for its bus. */
export interface BusParts<P extends Port> extends HostParts<P> {
  /** How the line stands; the bus writes it. It is made before the bus, for those who show it in every view. */
  readonly link: Signal<LinkState>;
  readonly line: Line;
  /** Shows the log. */
  readonly trace: LogTrace;
  readonly storage: PageStorage;
}

/** How a line stands on the way to another one. */
const ON_THE_WAY: ReadonlySet<LinkState['kind']> = new Set(['closing', 'closed', 'opening']);

/** The bus of this window: how its line stands, what is said on it, and every act on it. */
export class Bus<P extends Port = Port> {
  readonly link: ReadonlySignal<LinkState>;
  /** Whether a line is being opened, from the act on, before the session says so. */
  readonly opening = signal(false);
  /** Whether this window has serial ports at all. */
  readonly hasSerial: boolean;
  readonly connected = computed(() => this.link.value.kind === 'open');
  /** The ports that were chosen before and are plugged in. */
  readonly ports: ReadonlySignal<readonly P[]>;
  /** How a port is opened. A change holds from the next opening on. */
  readonly settings: { value: LinkSettings };
  /** How transactions are carried out. A change holds from the next request on. */
  readonly rules: { readonly value: TransactionRules };
  readonly #rules: KeptChoice<TransactionRules>;
  /** How fast the virtual bus goes. */
  readonly pace: { readonly value: Pace };
  readonly #pace: KeptChoice<Pace>;
  readonly errors = signal(noErrors);
  /** The adapter's lines, once they were asked for; and whether it took those that were set last. */
  readonly signals: Signal<{ readonly inputs?: InputSignals | undefined; readonly taken: boolean }> = signal({
    taken: true,
  });
  readonly readOnly = signal(true);
  readonly #requests = new SentRequests((command) => this.#host.post(command));
  readonly sending = this.#requests.sending;
  readonly question = signal<Question | undefined>(undefined);
  /** The request that was sent last, or that was to be sent. */
  readonly asked = this.#requests.asked;
  /** Why that was not sent. */
  readonly refused = this.#requests.refused;
  /** Whether the virtual devices answer what arrives on the port; nothing is sent meanwhile. */
  readonly serving = signal(false);
  /** What became of the last request; `undefined` as soon as something else is to be sent. */
  readonly last = this.#requests.last;
  /** Whether the session works in the window, because a worker cannot tell adapters of one kind apart. */
  readonly inWindow: ReadonlySignal<boolean>;
  readonly virtual: VirtualDevices;
  readonly log: BusLog;
  readonly #jobs = new BusJobs();
  /** Whether a job runs, which ends with the page. */
  readonly works = this.#jobs.anyRuns;
  readonly #parts: BusParts<P>;
  readonly #host: SessionHost<P>;
  /** The port that was opened last. */
  #port: P | undefined;
  /** Somebody has closed the line, or has asked for another: jobs end before it is closed. */
  #leaves = false;
  #count = 0;

  constructor(parts: BusParts<P>) {
    this.#parts = parts;
    const { link, serial, line, trace, storage } = parts;
    this.link = link;
    this.hasSerial = serial !== undefined;
    this.settings = portSettings(line, storage);
    // What a tab works with is its own: its session is in the midst of it.
    this.rules = this.#rules = new KeptChoice(storage, 'bus-rules', defaultRules, readRules, 'tab');
    this.pace = this.#pace = new KeptChoice<Pace>(storage, 'virtual-pace', 'line', readPace, 'tab');
    this.log = new BusLog(trace);
    this.virtual = new VirtualDevices(storage, (order) => this.#host.post({ kind: 'virtual', order }));
    this.#host = new SessionHost(parts, {
      tell: (news) => batch(() => this.#take(news)),
      began: () => {
        this.#host.post({ kind: 'set-rules', rules: this.rules.value });
        this.#host.post({ kind: 'set-read-only', readOnly: this.readOnly.peek() });
      },
      gone: (why) => {
        if (why) link.value = { kind: 'no-session', why };
        this.#drop();
      },
    });
    this.ports = this.#host.ports;
    this.inWindow = this.#host.inWindow;
    effect(() => {
      link.value;
      void this.#host.look();
    });
  }

  /** How the jobs of a kind stand: at most one of each runs. */
  job(kind: JobKind): ReadonlySignal<JobState> {
    return this.#jobs.state(kind);
  }

  /** Lets the person choose a port, and opens it. */
  async connect(): Promise<void> {
    const { serial, link } = this.#parts;
    if (serial === undefined) return;
    link.value = { kind: 'choosing' };
    const choice = await choosePort(serial);
    if (choice.kind === 'refused') link.value = choice;
    else await this.open(choice.port);
  }

  /** Opens a port that was chosen before. */
  async open(port: P): Promise<void> {
    this.#port = port;
    this.#leaves = true;
    await this.#host.startFor(port);
    this.opening.value = true;
    this.#host.post({ kind: 'open-port', port: port.getInfo(), settings: this.#used() });
  }

  /** Connects to the virtual bus. */
  openVirtual(): void {
    this.#port = undefined;
    this.#leaves = true;
    this.#host.start();
    this.opening.value = true;
    this.virtual.tellAll();
    this.#host.post({ kind: 'open-virtual', settings: this.#used(), pace: this.pace.value });
  }

  /** Opens the line that is connected again, with the settings of now. */
  reconnect(): void {
    if (this.#port === undefined) this.openVirtual();
    else void this.open(this.#port);
  }

  disconnect(): void {
    this.#leaves = true;
    this.#opened(false);
    this.#host.post({ kind: 'close' });
  }

  /** Lets the virtual devices answer on the port that is connected, or no longer. */
  serve(on: boolean): void {
    if (on) this.virtual.tellAll();
    this.#host.post({ kind: 'serve', on });
  }

  setRules(rules: TransactionRules): void {
    this.#rules.value = rules;
    this.#host.post({ kind: 'set-rules', rules });
  }

  setPace(pace: Pace): void {
    this.#pace.value = pace;
    const link = this.link.peek();
    if (link.kind === 'open' && link.adapter.kind === 'virtual') this.openVirtual();
  }

  setReadOnly(readOnly: boolean): void {
    batch(() => {
      this.readOnly.value = readOnly;
      this.refused.value = undefined;
    });
    this.#host.post({ kind: 'set-read-only', readOnly });
  }

  setSignals(signals: OutputSignals): void {
    this.#host.post({ kind: 'set-signals', signals });
  }

  /** Sends a request if the guard allows it. While one is being sent, another is not. */
  send(request: Uint8Array, transport: TransactionRules['transport']): void {
    if (this.sending.peek()) return;
    // While the virtual devices answer, the mode is theirs.
    if (!this.serving.peek()) this.#setTransport(transport);
    this.#requests.send(++this.#count, { request, transport });
  }

  /** Sends the request that “Read only” has held back, and leaves it on for all others. */
  sendOnce(): void {
    const held = this.#requests.held;
    if (held === undefined) return;
    this.#setTransport(held.transport);
    this.#requests.sendOnce(++this.#count, held);
  }

  /** Ends all that is going on. */
  stopAll(): void {
    this.#host.post({ kind: 'stop' });
  }

  /**
   * Begins a job, in this mode if it needs one; `take` is told what it finds. While a line is being opened, it begins when that is
   * open. Nothing if one of its kind runs.
   */
  start(order: JobOrder, take: TakeNews, transport?: TransactionRules['transport']): void {
    if (this.#jobs.runs(order.kind)) return;
    const id = ++this.#count;
    this.#jobs.begin(order.kind, id, take);
    this.last.value = undefined;
    if (transport !== undefined) this.#setTransport(transport);
    const begin = () => this.#host.post({ kind: 'start-job', id, order, confirmed: false });
    if (this.opening.peek()) this.#jobs.hold(id, begin);
    else if (this.#host.works) begin();
    else this.#jobs.end(id, { kind: this.#endOfLine });
  }

  /** Stops a job. A sequence can be stopped twice: its steps, and what it does finally. */
  stop(kind: JobKind): void {
    const id = this.#jobs.stop(kind);
    if (id !== undefined) this.#host.post({ kind: 'stop-job', id });
  }

  /** Answers the question that was asked. */
  answer(yes: boolean): void {
    const question = this.question.peek();
    this.question.value = undefined;
    if (question === undefined) return;
    const { command } = question;
    if (!yes) this.#jobs.end(command.id, { kind: 'declined' });
    else if (command.kind === 'send') this.#requests.post(command);
    else this.#host.post(command);
  }

  /** The line that was being opened is open, or will not be: the jobs that waited for it begin, or are over. */
  #opened(isOpen: boolean): void {
    this.opening.value = false;
    this.#jobs.release(isOpen);
  }

  /** The session is gone: it says nothing more of what it was to do. */
  #drop(): void {
    batch(() => {
      this.#requests.drop();
      this.question.value = undefined;
      this.serving.value = false;
      this.#opened(false);
      this.signals.value = { ...this.signals.peek(), inputs: undefined };
      this.#jobs.endAll({ kind: this.#endOfLine });
    });
  }

  /** The settings that the line is opened with now. */
  #used(): LinkSettings {
    this.#parts.line.use();
    return this.settings.value;
  }

  #setTransport(transport: TransactionRules['transport']): void {
    const rules = this.rules.value;
    if (rules.transport !== transport) this.setRules({ ...rules, transport });
  }

  /** How a job ends that has no line any more. */
  get #endOfLine(): 'lost' | 'disconnected' {
    return this.link.peek().kind === 'lost' ? 'lost' : 'disconnected';
  }

  /** Takes what the session tells. */
  #take(news: SessionNews): void {
    switch (news.kind) {
      case 'state':
        this.#parts.link.value = news.state;
        if (news.state.kind === 'open') {
          this.signals.value = { taken: true };
          this.#leaves = false;
        }
        if (!ON_THE_WAY.has(news.state.kind)) this.#opened(news.state.kind === 'open');
        break;
      case 'signals':
        this.signals.value = { inputs: news.signals, taken: news.set };
        break;
      case 'lines':
        this.log.add(news.lines);
        break;
      case 'errors':
        this.errors.value = news.errors;
        break;
      case 'result':
        this.#requests.ended(news.id, { last: news.result });
        break;
      case 'ask': {
        const { id, request, why, allowed } = news;
        this.#requests.ended(id);
        this.question.value = {
          command: { kind: 'send', id, request, confirmed: true, ...(allowed && { allowed }) },
          why,
        };
        break;
      }
      case 'ask-job': {
        const { id, order, why } = news;
        this.question.value = { command: { kind: 'start-job', id, order, confirmed: true }, why };
        break;
      }
      case 'refused':
        this.#requests.ended(news.id, { refused: news.why });
        this.#jobs.end(news.id, { kind: 'refused', why: news.why });
        break;
      case 'jobs':
        this.#jobs.take(news.news);
        break;
      case 'serving':
        this.serving.value = news.on;
        this.refused.value = undefined;
        break;
      case 'virtual':
        this.virtual.take(news.news);
        break;
      case 'job-ended': {
        const { kind } = this.link.peek();
        const stays = kind === 'open' && !this.#leaves;
        const byItself = stays || (kind !== 'lost' && this.#jobs.wasStopped(news.id));
        this.#jobs.end(news.id, { kind: byItself ? 'stopped' : this.#endOfLine });
        break;
      }
    }
  }
}
