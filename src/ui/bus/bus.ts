import {
  choosePort,
  type LinkSettings,
  makeClock,
  portsLike,
  Session,
  type SessionCommand,
  type SessionNews,
  serialSupport,
  type TransactionRules,
  WebSerialLink,
} from '../../bus/index.ts';
import { type BusState, SessionView } from '../../workbench/index.ts';
import { busStatus } from '../parts/bus-status.ts';
import { type Running, startWorker, type WorkerEnd } from '../parts/workers/start-worker.ts';
import { busWords } from './bus-words.ts';
import { rulesMemory, settingsMemory } from './memories.ts';

/**
 * The bus of this window: its session works in a worker, or in the window where a worker could not tell its port from
 * another. It holds nothing that is drawn with the rest of the page, so that a busy line does not draw all of it.
 */
class Bus extends SessionView {
  #worker: Running<SessionCommand> | undefined;

  constructor() {
    super({
      link: serialSupport(window) ?? { kind: 'closed' },
      settings: settingsMemory.value,
      rules: rulesMemory.value,
    });
  }

  override set(change: Partial<BusState>): void {
    if (change.link) busStatus.value = busWords.linkShort(change.link);
    super.set(change);
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
    this.command({ kind: 'open-port', port: info, settings: this.state.settings });
  }

  /** Gives commands to the session in the worker, which is started if there is none. */
  host(commands: readonly SessionCommand[]): void {
    this.#host(undefined);
    for (const command of commands) this.command(command);
  }

  setSettings(settings: LinkSettings): void {
    settingsMemory.value = settings;
    this.set({ settings });
  }

  override setRules(rules: TransactionRules): void {
    rulesMemory.value = rules;
    super.setRules(rules);
  }

  #host(port: SerialPort | undefined): void {
    const inWindow = port !== undefined;
    if (this.hasSession && !inWindow && !this.state.inWindow) return;
    this.close();
    this.#worker?.end();
    this.#worker = undefined;
    this.drop();
    this.set({ inWindow });
    if (port) {
      const clock = makeClock();
      const session = new Session({
        clock,
        portLink: () => Promise.resolve(new WebSerialLink(port, clock)),
        tell: (news) => this.take(news),
      });
      this.attach((command) => void session.take(command));
    } else {
      const worker = startWorker<SessionCommand, SessionNews>('session', (news) => this.take(news), this.#ended);
      this.#worker = worker;
      this.attach((command) => worker.post(command));
    }
  }

  /** The worker has ended without being told to: the next that connects starts another. */
  readonly #ended = (why: WorkerEnd): void => {
    this.set({ link: { kind: 'no-session', why } });
    this.#worker = undefined;
    this.drop();
  };
}

export const bus = new Bus();
