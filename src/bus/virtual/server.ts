import { coilByteCount, type EntityTable, entityTables, type Trait } from '../../devices/index.ts';
import {
  BROADCAST,
  decodeFrame,
  encodeFrame,
  type Problem,
  type Reading,
  type SerialLine,
  type SerialMode,
  type Values,
} from '../../modbus/index.ts';
import { type CellRange, Cells } from './cells.ts';
import { Counters } from './counters.ts';
import type { Device, DeviceLine } from './device.ts';
import { RESTART } from './functions/diagnosis.ts';
import {
  type Effect,
  exception,
  ILLEGAL_DATA_ADDRESS,
  ILLEGAL_DATA_VALUE,
  ILLEGAL_FUNCTION,
  SILENCE,
} from './functions/handler.ts';
import { handlers } from './functions/index.ts';

/** Whether a server with a trait takes a request that breaks a rule of the specification. */
const tolerates: Readonly<Record<Trait, (server: VirtualServer, problem: Problem) => boolean>> = {
  // Its cells are registers, each with an address.
  'one-address-each-value': () => false,
  'any-value-is-on': (_, { code }) => code === 'coil-value-illegal',
  'byte-count-plus-one': (server, problem) =>
    problem.code === 'count-contradicts-quantity' && problem.got === coilByteCount(problem.quantity, server),
};

/** The parts of a device; it does not have those that are absent. */
export interface ServerParts {
  readonly name: string;
  readonly unit: number;
  readonly tables?: Partial<Record<EntityTable, readonly CellRange[]>>;
  /** Inputs are the same as coils, and input registers the same as holding registers (AP 4.3). */
  readonly overlap?: boolean;
  /** By file number, its registers from record 0 on. */
  readonly files?: Readonly<Record<number, readonly number[]>>;
  readonly fifos?: Readonly<Record<number, readonly number[]>>;
  readonly objects?: Readonly<Record<number, string>>;
  readonly conformityLevel?: number;
  /** Hexadecimal pairs. */
  readonly serverId?: string;
  readonly exceptionStatus?: number;
  /** The function codes it knows; all public ones if absent. */
  readonly functions?: readonly number[];
  readonly traits?: readonly Trait[];
  readonly line?: SerialLine;
  /** Milliseconds. */
  readonly delay?: number;
  /** What it does by itself: called before each access, with the milliseconds since the one before. */
  readonly behaviour?: (device: Device, elapsed: number) => void;
}

/** Why a device says nothing. */
export type SilenceReason =
  /** The request is for another unit. */
  | 'other-unit'
  /** A broadcast is carried out or ignored, without a reply. */
  | 'broadcast'
  | 'listen-only'
  /** The checksum does not hold, or the bytes are not a frame. */
  | 'broken-frame'
  /** The function has no reply. */
  | 'no-reply'
  /** Its line has other settings, so that it hears only noise. */
  | 'other-settings';

/** What a device does with a frame on its line. */
export type Heard =
  | { readonly does: 'answer'; readonly reply: Uint8Array; readonly exceptionCode: number | undefined }
  | { readonly does: 'nothing'; readonly why: SilenceReason };

const EXCEPTION = 0x80;
const BYTE = 0xff;
const DEFAULT_DELAY = 2;

/** A device of the virtual bus. It answers everything it hears as the specification says, and never throws. */
export class VirtualServer implements Device, DeviceLine {
  name: string;
  unit: number;
  line: SerialLine | undefined;
  delay: number;
  readonly tables: Readonly<Record<EntityTable, Cells>>;
  readonly files: Map<number, Uint16Array>;
  readonly fifos: Map<number, number[]>;
  readonly objects: Map<number, string>;
  readonly conformityLevel: number;
  serverId: string;
  exceptionStatus: number;
  busy = false;
  readonly counters = new Counters();
  readonly traits: readonly Trait[];
  readonly #functions: ReadonlySet<number> | undefined;
  readonly #behaviour: ServerParts['behaviour'];
  #seenAt: number | undefined;

  constructor(parts: ServerParts) {
    this.name = parts.name;
    this.unit = parts.unit;
    this.line = parts.line;
    this.delay = parts.delay ?? DEFAULT_DELAY;
    const { tables = {}, files = {}, fifos = {}, objects = {}, functions } = parts;
    const cells = entityTables.map((table) => [table, new Cells(tables[table] ?? [])] as const);
    const own = Object.fromEntries(cells) as Record<EntityTable, Cells>;
    const shared = { 'discrete-input': own.coil, 'input-register': own['holding-register'] };
    this.tables = parts.overlap ? { ...own, ...shared } : own;
    this.files = new Map(Object.entries(files).map(([file, records]) => [Number(file), Uint16Array.from(records)]));
    this.fifos = new Map(Object.entries(fifos).map(([pointer, values]) => [Number(pointer), [...values]]));
    this.objects = new Map(Object.entries(objects).map(([id, text]) => [Number(id), text]));
    this.conformityLevel = parts.conformityLevel ?? 0x83;
    this.serverId = parts.serverId ?? '';
    this.exceptionStatus = parts.exceptionStatus ?? 0;
    this.traits = parts.traits ?? [];
    this.#functions = functions && new Set(functions);
    this.#behaviour = parts.behaviour;
  }

  /** Lets it do what it does by itself until now, the clock's time. */
  refresh(now: number): void {
    this.#behaviour?.(this, now - (this.#seenAt ?? now));
    this.#seenAt = now;
  }

  /** Takes bytes on its line that are not a frame. */
  hearNoise(): void {
    this.counters.brokenFrame();
  }

  /**
   * Hears one frame, carries it out if it is meant for it, and says what it answers. `refusing` makes it refuse the request
   * with this exception instead.
   */
  hear(frame: Uint8Array, transport: SerialMode, refusing?: number): Heard {
    const { counters } = this;
    const asked = decodeFrame(frame, { transport, direction: 'request' });
    if (asked.outcome.kind !== 'whole' || 'checksum' in asked.forced || asked.functionCode === undefined) {
      counters.brokenFrame();
      return { does: 'nothing', why: 'broken-frame' };
    }
    counters.add('busMessages');
    const broadcast = asked.unitId === BROADCAST;
    if (!broadcast && asked.unitId !== this.unit) return { does: 'nothing', why: 'other-unit' };
    counters.add('serverMessages');
    const { listenOnly } = counters;
    const obeys = !listenOnly || asked.fields['subFunction'] === RESTART;
    const doesIt = obeys && (!broadcast || asked.description?.broadcast === true);
    const effect = doesIt ? this.#perform(asked, refusing) : SILENCE;
    counters.received(broadcast);
    if (doesIt && effect.kind !== 'exception' && !handlers[asked.functionCode]?.uncounted) counters.carriedOut();
    if (broadcast || listenOnly || effect.kind === 'silence') {
      counters.add('noResponses');
      return { does: 'nothing', why: broadcast ? 'broadcast' : listenOnly ? 'listen-only' : 'no-reply' };
    }
    return this.#answer(frame, asked, effect, transport);
  }

  /** Whether a frame is meant for this device alone. */
  isAsked(frame: Uint8Array, transport: SerialMode): boolean {
    return decodeFrame(frame, { transport, direction: 'request' }).unitId === this.unit;
  }

  /** The order of the checks is that of the state diagrams of AP 6: function, value, address. */
  #perform(asked: Reading, refusing: number | undefined): Effect {
    if (refusing !== undefined) return exception(refusing & BYTE);
    const { functionCode = 0 } = asked;
    const handler = this.#functions?.has(functionCode) === false ? undefined : handlers[functionCode];
    if (handler === undefined) return exception(ILLEGAL_FUNCTION);
    const wrong = asked.problems.filter((problem) => problem.severity === 'error' && !this.#tolerates(problem));
    const short = wrong.some(({ code }) => code === 'pdu-short');
    if (!short && handler.knows?.(asked) === false) return exception(ILLEGAL_FUNCTION);
    const ofAddress = ({ code }: Problem) =>
      code === 'address-range-over-end' || handler.addressProblems?.includes(code) === true;
    if (wrong.some((problem) => !ofAddress(problem))) return exception(ILLEGAL_DATA_VALUE);
    return wrong.length > 0 ? exception(ILLEGAL_DATA_ADDRESS) : handler.perform(this, asked);
  }

  #tolerates(problem: Problem): boolean {
    return this.traits.some((trait) => tolerates[trait](this, problem));
  }

  #answer(
    frame: Uint8Array,
    asked: Reading,
    effect: Exclude<Effect, { kind: 'silence' }>,
    transport: SerialMode,
  ): Heard {
    const { counters } = this;
    const { functionCode = 0 } = asked;
    if (effect.kind === 'exception') {
      const { exceptionCode } = effect;
      counters.add('exceptions');
      counters.sent(exceptionCode);
      const reply = this.#encode(asked, transport, functionCode | EXCEPTION, { exceptionCode });
      return { does: 'answer', reply, exceptionCode };
    }
    counters.sent(undefined);
    const reply = effect.kind === 'echo' ? frame : this.#encode(asked, transport, functionCode, effect.fields);
    return { does: 'answer', reply, exceptionCode: undefined };
  }

  #encode({ unitId }: Reading, transport: SerialMode, functionCode: number, fields: Values): Uint8Array {
    return encodeFrame({ transport, direction: 'response', unitId, functionCode, fields });
  }
}
