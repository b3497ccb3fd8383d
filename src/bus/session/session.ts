import { decodeFrame, toHex } from '../../modbus/index.ts';
import type { Clock } from '../clock.ts';
import { type Permission, permissionFor, type Refusal } from '../guard.ts';
import { holdOf, type JobNews, requestsOf, startJob } from '../jobs/index.ts';
import type { Hold, RunningJob } from '../jobs/job.ts';
import type { PortChoice } from '../link/adapters.ts';
import type { Link, LinkSettings } from '../link/link.ts';
import { linesOf } from '../log/line.ts';
import { BusClient } from '../transaction/bus-client.ts';
import { defaultRules, type TransactionRules } from '../transaction/rules.ts';
import { VirtualBench } from '../virtual/bench.ts';
import { PortServer } from '../virtual/port-server.ts';
import { VirtualLink } from '../virtual/virtual-link.ts';
import { type SessionCommand, type SessionNews, sentResult } from './messages.ts';
import { Reports } from './reports.ts';

export interface SessionParts {
  readonly clock: Clock;
  /** A link to this port; `undefined` if the port is not there. */
  readonly portLink: (port: PortChoice) => Promise<Link | undefined>;
  readonly tell: (news: SessionNews) => void;
}

/** One connection from its beginning to its end: one link, one transaction at a time, and the log of both. */
export class Session {
  readonly #parts: SessionParts;
  readonly #bench: VirtualBench;
  readonly #reports: Reports;
  #link: Link | undefined;
  #client: BusClient | undefined;
  #server: PortServer | undefined;
  #ownRules: TransactionRules = defaultRules;
  /** Somebody has asked for late replies on the virtual bus. */
  #wasLate = false;
  #readOnly = true;
  #writable: ReadonlySet<number> = new Set();
  #jobs = new Map<number, RunningJob>();
  #holds = new Map<number, Hold>();
  /** Somebody has closed the link, so that no job may open it. */
  #closed = false;

  constructor(parts: SessionParts) {
    this.#parts = parts;
    this.#reports = new Reports(parts.clock, parts.tell);
    this.#bench = new VirtualBench(parts.clock, (news) => parts.tell({ kind: 'virtual', news }));
  }

  /** Does what a window asks. Never throws or rejects. */
  async take(command: SessionCommand): Promise<void> {
    switch (command.kind) {
      case 'open-port': {
        const link = await this.#parts.portLink(command.port);
        if (link === undefined)
          return this.#reports.tell({ kind: 'state', state: { kind: 'refused', why: 'cancelled' } });
        await this.#use(link);
        await link.open(command.settings);
        return;
      }
      case 'open-virtual': {
        const { bus } = this.#bench;
        bus.settings = { ...bus.settings, pace: command.pace };
        const link = new VirtualLink(bus, this.#parts.clock);
        await this.#use(link);
        await link.open(command.settings);
        return;
      }
      case 'virtual':
        this.#bench.take(command.order);
        this.#wasLate ||= this.#bench.bus.faults.some(({ fault }) => fault.kind === 'late');
        if (this.#client) this.#client.rules = this.#rules;
        return;
      case 'serve':
        await this.#endJobs();
        this.#restart();
        if (command.on) this.#serve();
        return;
      case 'close':
        this.#closed = true;
        await this.#endJobs();
        await this.#link?.close();
        return;
      case 'set-signals': {
        const set = (await this.#link?.setSignals(command.signals)) ?? false;
        this.#reports.tell({ kind: 'signals', set, signals: await this.#link?.getSignals() });
        return;
      }
      case 'set-rules':
        this.#ownRules = command.rules;
        this.#bench.bus.settings = { ...this.#bench.bus.settings, transport: command.rules.transport };
        if (this.#client) this.#client.rules = this.#rules;
        return;
      case 'set-read-only':
        this.#readOnly = command.readOnly;
        return;
      case 'send':
        await this.#send(command);
        return;
      case 'start-job':
        await this.#start(command);
        return;
      case 'stop-job':
        this.#jobs.get(command.id)?.stop();
        return;
      case 'stop':
        this.#restart();
        return;
    }
  }

  /** The virtual bus has no echo and no late reply unless a fault asks for one, so that nothing has to be found out. */
  get #rules(): TransactionRules {
    if (!(this.#link instanceof VirtualLink)) return this.#ownRules;
    const echoes = this.#bench.bus.faults.some(({ fault }) => fault.kind === 'echo');
    const { echo } = this.#ownRules;
    return { ...this.#ownRules, echo: echo === 'auto' && !echoes ? 'off' : echo, punctual: !this.#wasLate };
  }

  async #send({ id, request, confirmed, allowed }: Extract<SessionCommand, { kind: 'send' }>): Promise<void> {
    const permission = this.#permission([request], { confirmed, allowed });
    if (permission.kind !== 'free') {
      this.#reports.tell(
        permission.kind === 'ask' ? { ...permission, id, request, ...(allowed && { allowed }) } : { ...permission, id },
      );
      return;
    }
    const transaction = this.#client?.transact(request, this.#rules);
    if (transaction === undefined) return;
    const result = await transaction.result;
    this.#reports.tell({ kind: 'result', id, result: sentResult(result) });
  }

  async #start({ id, order, confirmed }: Extract<SessionCommand, { kind: 'start-job' }>): Promise<void> {
    const hold = holdOf(order);
    const permission = this.#permission(requestsOf(order), { confirmed }, hold);
    if (permission.kind !== 'free') {
      this.#reports.tell(
        permission.kind === 'ask' ? { ...permission, kind: 'ask-job', id, order } : { ...permission, id },
      );
      return;
    }
    this.#jobs.get(id)?.stop();
    const client = this.#client;
    const link = this.#link;
    if (client === undefined || link === undefined) {
      this.#reports.tell({ kind: 'job-ended', id });
      return;
    }
    const { clock } = this.#parts;
    // A job sends the rest of its requests on the line it was begun for, and on no other.
    const current = () => (this.#link === link ? this.#client : undefined) ?? client;
    const tell = (news: JobNews) => this.#reports.ofJob(id, news);
    const reopen = (settings: LinkSettings) => this.#reopen(link, settings);
    if (hold) this.#holds.set(id, hold);
    const parts = {
      get client() {
        return current();
      },
      clock,
      tell,
      link,
      reopen,
      log: this.#reports.line,
    };
    const job = startJob(order, parts);
    this.#jobs.set(id, job);
    await job.ended;
    if (this.#jobs.get(id) !== job) return;
    this.#jobs.delete(id);
    this.#holds.delete(id);
    this.#reports.tell({ kind: 'job-ended', id });
  }

  /**
   * Whether requests may be sent. What somebody has agreed to may, and is remembered if asking once is enough. Nobody is asked
   * about virtual devices, which can be put back.
   */
  #permission(
    requests: readonly Uint8Array[],
    { confirmed, allowed }: { readonly confirmed: boolean; readonly allowed?: true | undefined },
    hold?: Hold,
  ): Permission {
    const inTheWay = this.#inTheWay(hold);
    if (inTheWay) return { kind: 'refused', why: inTheWay };
    const { transport } = this.#rules;
    const readings = requests.map((request) => decodeFrame(request, { transport, direction: 'request' }));
    // Whoever sends a request though only reading is allowed has agreed to it.
    const writable = allowed ? new Set(readings.flatMap(({ unitId }) => unitId ?? [])) : this.#writable;
    const guard = { readOnly: this.#readOnly && !allowed, writable };
    const permissions = readings.map((reading) => permissionFor(reading, guard));
    const refused = permissions.find(({ kind }) => kind === 'refused');
    if (refused) return refused;
    const asked = permissions.find((permission) => permission.kind === 'ask' && !permission.once);
    const first = asked ?? permissions.find(({ kind }) => kind === 'ask');
    if (first === undefined || this.#link instanceof VirtualLink) return { kind: 'free' };
    if (!confirmed) return first;
    const units = readings.flatMap(({ unitId }, at) =>
      isOnce(permissions[at]) && unitId !== undefined ? [unitId] : [],
    );
    this.#writable = new Set([...this.#writable, ...units]);
    return { kind: 'free' };
  }

  /** Why a request may not be sent now, or why a job that needs the line to itself may not begin. */
  #inTheWay(hold: Hold | undefined): Refusal | undefined {
    if (this.#server) return 'serving';
    const [held] = this.#holds.values();
    if (held) return held;
    const isBusy = this.#jobs.size > 0 || (this.#client?.pending ?? 0) > 0;
    return hold && isBusy ? 'busy' : undefined;
  }

  /** Opens the link again for a job, unless it is lost or somebody has closed it or chosen another. */
  async #reopen(link: Link, settings: LinkSettings): Promise<boolean> {
    const may = () => this.#link === link && !this.#closed;
    const { kind } = link.state;
    if (!may() || (kind !== 'open' && kind !== 'failed')) return false;
    await link.close();
    return may() && (await link.open(settings)).kind === 'open';
  }

  /** Takes another link in place of the one there was. */
  async #use(link: Link): Promise<void> {
    const before = this.#link;
    if (before !== link) {
      await this.#endJobs();
      this.#client?.dispose();
      await before?.close();
    }
    this.#link = link;
    this.#closed = false;
    // The same unit on another line is another device.
    this.#writable = new Set();
    link.listen((event) => {
      if (event.kind !== 'state' || this.#link !== link) return;
      if (event.state.kind === 'opening') this.#reports.forgetErrors();
      this.#reports.tell({ kind: 'state', state: event.state });
      if (this.#server && event.state.kind !== 'open') this.#restart();
    });
    this.#restart();
  }

  /** Ends all jobs while they still have a line for their last requests; called again, it ends those too. */
  async #endJobs(): Promise<void> {
    const jobs = [...this.#jobs.values()];
    if (jobs.length === 0) return;
    this.#restart();
    await Promise.all(jobs.map(({ ended }) => ended));
  }

  /** Ends everything that is going on, and begins again on the same link. */
  #restart(): void {
    for (const job of this.#jobs.values()) job.stop();
    this.#client?.dispose();
    // What a line is asked while it is served is not known to the client.
    const known = this.#server === undefined && this.#link && this.#client?.isOf(this.#link) ? this.#client : undefined;
    if (this.#server) this.#reports.tell({ kind: 'serving', on: false });
    this.#server?.stop();
    this.#server = undefined;
    if (this.#link === undefined) return;
    const client = known?.successor(this.#rules) ?? new BusClient(this.#link, this.#parts.clock, this.#rules);
    this.#client = client;
    const { origin } = this.#parts.clock;
    client.listen((event) => {
      switch (event.kind) {
        case 'result':
          this.#reports.lines(linesOf(event.result, event.result.transport, origin));
          break;
        case 'stray': {
          // The listening job reports it.
          if (this.#inTheWay(undefined) === 'listening') break;
          const { bytes, at, what } = event.stray;
          const { transport } = this.#rules;
          const kind = what === 'other' ? 'heard' : what;
          this.#reports.line({ time: origin + at, direction: 'received', transport, kind, hex: toHex(bytes) });
          break;
        }
        case 'line-error':
          this.#reports.lineError(event.error);
          break;
      }
    });
  }

  /** Lets the virtual devices answer on the port. */
  #serve(): void {
    const link = this.#link;
    const { bus } = this.#bench;
    if (link?.state.kind !== 'open' || link instanceof VirtualLink) return;
    this.#client?.dispose();
    // A real line is slow by itself.
    bus.settings = { ...bus.settings, pace: 'fast' };
    this.#server = new PortServer({
      link,
      clock: this.#parts.clock,
      bus,
      rules: () => this.#rules,
      log: this.#reports.line,
    });
    this.#reports.tell({ kind: 'serving', on: true });
  }
}

const isOnce = (permission: Permission | undefined) => permission?.kind === 'ask' && permission.once;
