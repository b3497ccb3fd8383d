import { bitsPerCharacter, charactersTime, rtuSilences, type SerialLine, type SerialMode } from '../../modbus/index.ts';
import type { Clock } from '../clock.ts';
import { Listeners } from '../listeners.ts';
import { type Chance, type Fault, type FaultRule, spoil } from './faults.ts';
import type { Heard, SilenceReason, VirtualServer } from './server.ts';

/** What happens on the virtual bus, for those who watch. Times are the clock's. */
export type VirtualBusEvent =
  | { readonly kind: 'request'; readonly bytes: Uint8Array; readonly at: number }
  /** Every device hears every frame; what it makes of it. */
  | {
      readonly kind: 'heard';
      readonly server: VirtualServer;
      readonly at: number;
      readonly does: 'answer' | 'nothing';
      readonly why: SilenceReason | undefined;
      readonly exceptionCode: number | undefined;
    }
  /** What it sends from `at` on, and the fault that was asked for. */
  | {
      readonly kind: 'reply';
      readonly server: VirtualServer;
      readonly bytes: Uint8Array;
      readonly at: number;
      readonly fault: Fault | undefined;
    };

/** How the bus behaves; it may be changed at any time. Times are milliseconds. */
export interface VirtualBusSettings {
  readonly transport: SerialMode;
  /** `line`: characters, silences and answers take the time that they take on a real line. */
  readonly pace: 'line' | 'fast';
  /** How often the adapter hands over what has come; 0: each reply when it is whole. */
  readonly lump: number;
  /** The adapter gives back what is sent. */
  readonly echo: boolean;
}

const MICROSECONDS = 1000;
/** A frame on the line may be in pieces, as long as no silence parts them. */
const MOST_PENDING = 4096;

/** A line with devices on it; the client is not one of them. */
export class VirtualBus {
  servers: readonly VirtualServer[];
  faults: readonly FaultRule[] = [];
  settings: VirtualBusSettings = { transport: 'rtu', pace: 'line', lump: 0, echo: false };
  readonly #clock: Clock;
  readonly #chance: Chance;
  readonly #listeners = new Listeners<VirtualBusEvent>();
  #pending: number[] = [];
  /** When the last character of a request has left. */
  #freeAt = Number.NEGATIVE_INFINITY;
  #offEnd = () => {};
  #previous: Uint8Array | undefined;

  constructor(
    clock: Clock,
    servers: readonly VirtualServer[] = [],
    chance: Chance = () => Math.floor(256 * Math.random()),
  ) {
    this.#clock = clock;
    this.servers = servers;
    this.#chance = chance;
  }

  /** Answers how to stop listening. */
  listen(listener: (event: VirtualBusEvent) => void): () => void {
    return this.#listeners.add(listener);
  }

  /** Puts bytes on the line, at its speed; what comes back is handed to `deliver` as it comes. */
  send(bytes: Uint8Array, line: SerialLine, deliver: (bytes: Uint8Array) => void): void {
    const now = this.#clock.now();
    this.#freeAt = Math.max(now, this.#freeAt) + this.#time(line, bytes.length);
    this.#pending = [...this.#pending, ...bytes].slice(-MOST_PENDING);
    if (this.settings.echo) this.#deliver(bytes, this.#freeAt - this.#time(line, bytes.length), line, deliver);
    this.#offEnd();
    this.#offEnd = this.#clock.after(this.#freeAt + this.#silence(line) - now, () => {
      const request = Uint8Array.from(this.#pending);
      this.#pending = [];
      this.hear(request, line, deliver);
    });
  }

  #time(line: SerialLine, characters: number): number {
    return this.settings.pace === 'fast' ? 0 : charactersTime(line, characters) / MICROSECONDS;
  }

  /** An RTU frame ends with a silence, an ASCII frame with its last character. */
  #silence(line: SerialLine): number {
    const { pace, transport } = this.settings;
    return pace === 'fast' || transport === 'ascii'
      ? 0
      : rtuSilences(line.baud, bitsPerCharacter(line)).t35 / MICROSECONDS;
  }

  /** Lets the devices hear what has been on the line between two silences. */
  hear(request: Uint8Array, line: SerialLine, deliver: (bytes: Uint8Array) => void): void {
    const at = this.#clock.now();
    this.#listeners.tell({ kind: 'request', bytes: request, at });
    for (const server of this.servers) {
      server.refresh(at);
      const rule = this.#faultFor(server, request);
      const heard = this.#heard(server, request, line, rule);
      const answers = heard.does === 'answer';
      this.#listeners.tell({
        kind: 'heard',
        server,
        at,
        does: heard.does,
        why: answers ? undefined : heard.why,
        exceptionCode: answers ? heard.exceptionCode : undefined,
      });
      if (answers) this.#reply(server, request, heard.reply, rule, line, deliver);
    }
  }

  /** The fault for the reply of this device, if the request is for it. */
  #faultFor(server: VirtualServer, request: Uint8Array): FaultRule | undefined {
    if (this.faults.length === 0 || !server.isAsked(request, this.settings.transport)) return undefined;
    return this.faults.find(({ unit, times = 1 }) => times > 0 && (unit ?? server.unit) === server.unit);
  }

  #heard(server: VirtualServer, request: Uint8Array, line: SerialLine, rule: FaultRule | undefined): Heard {
    const { transport } = this.settings;
    if (server.line !== undefined && !sameLine(server.line, line)) {
      server.hearNoise();
      return { does: 'nothing', why: 'other-settings' };
    }
    const refusing = rule?.fault.kind === 'exception' ? rule.fault.exceptionCode : undefined;
    return server.hear(request, transport, refusing);
  }

  #reply(
    server: VirtualServer,
    request: Uint8Array,
    reply: Uint8Array,
    rule: FaultRule | undefined,
    line: SerialLine,
    deliver: (bytes: Uint8Array) => void,
  ): void {
    const { transport, pace } = this.settings;
    const fault = rule?.fault;
    if (rule?.times !== undefined) {
      const used = { ...rule, times: rule.times - 1 };
      this.faults = this.faults.flatMap((other) => (other !== rule ? [other] : used.times > 0 ? [used] : []));
    }
    const sent = { request, reply, previous: this.#previous };
    const bytes = fault === undefined ? reply : spoil(fault, sent, transport, this.#chance);
    this.#previous = reply;
    const working = (pace === 'fast' ? 0 : server.delay) + (fault?.kind === 'late' ? fault.by : 0);
    const from = Math.max(this.#clock.now() + working, this.#freeAt);
    this.#listeners.tell({ kind: 'reply', server, bytes, at: from, fault });
    if (bytes.length > 0) this.#deliver(bytes, from, line, deliver);
  }

  /** Hands over bytes that are on the line from `from` on. */
  #deliver(bytes: Uint8Array, from: number, line: SerialLine, deliver: (bytes: Uint8Array) => void): void {
    const now = this.#clock.now();
    const { lump } = this.settings;
    const character = this.#time(line, 1);
    const each = lump > 0 && character > 0 ? Math.max(1, Math.floor(lump / character)) : bytes.length;
    for (let at = 0; at < bytes.length; at += each) {
      const piece = bytes.slice(at, at + each);
      this.#clock.after(from + character * (at + piece.length) - now, () => deliver(piece));
    }
  }
}

const sameLine = (one: SerialLine, other: SerialLine): boolean =>
  one.baud === other.baud &&
  one.dataBits === other.dataBits &&
  one.parity === other.parity &&
  one.stopBits === other.stopBits;
