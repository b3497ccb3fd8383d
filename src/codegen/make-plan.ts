import {
  BROADCAST,
  decodeFrame,
  encodeFrame,
  FrameError,
  type FrameInput,
  type Reading,
  rawFunction,
  type Transport,
} from '../modbus/index.ts';
import type { UnitScale } from '../notation/index.ts';
import { plainWords } from '../notation/index.ts';
import type { Sequence } from '../sequences/index.ts';
import type { Code, Name, Routine, Table, Texts } from './code.ts';
import { aboutRequest, functionText, parameterText, requestName, rowsOf } from './describe.ts';
import { isSilent } from './facts.ts';
import { exceptionTexts, faultConstants, faultTexts } from './faults.ts';
import { fresh, wordsOf } from './plain-words.ts';
import type {
  BuildArgument,
  Plan,
  PlannedRequest,
  PlannedSequence,
  ProgramNote,
  ReplyValue,
  Settings,
} from './plan.ts';
import { plannedSteps } from './plan-steps.ts';
import { building } from './routines/build.ts';
import { checking } from './routines/check.ts';
import { asciiRoutines, crcWays } from './routines/checksums.ts';
import { envelopes } from './routines/envelope.ts';
import { numberRoutines } from './routines/numbers.ts';
import { RequestBytes } from './routines/request-bytes.ts';
import { toRawRoutine, typedInUnits } from './routines/scaled.ts';
import { usedBy } from './routines/used.ts';
import { takingsOf } from './routines/values.ts';
import { wantedRoutine } from './routines/wanted.ts';
import { shareRoutines } from './share.ts';
import { scaleKey, unitWords, writtenValues } from './written-values.ts';

/** A request that is to be planned, and what its user calls it. */
export interface AskedRequest {
  readonly name: string | undefined;
  readonly request: FrameInput;
}

export interface Planning {
  readonly plan: Plan;
  readonly notes: readonly ProgramNote[];
}

/** Bytes of a request; throws a `RangeError` for what has none. */
function bytesOf(input: FrameInput): Uint8Array {
  try {
    return encodeFrame(input);
  } catch (error) {
    if (error instanceof FrameError) throw new RangeError(`no bytes: ${error.message}`, { cause: error });
    throw error;
  }
}

/** What is written for these requests, all of one transport. Throws a `RangeError` for what has no bytes. */
export function makePlan(asked: readonly AskedRequest[], settings: Settings, sequence?: Sequence): Planning {
  const [first] = asked;
  if (first === undefined) throw new RangeError('no frames');
  const { transport } = first.request;
  if (asked.some(({ request }) => request.transport !== transport))
    throw new RangeError('frames of more than one transport');
  const maker = new PlanMaker(transport, settings);
  const requests = asked.map((one) => maker.request(one));
  const planned = sequence && maker.sequence(sequence, requests);
  return {
    plan: shareRoutines({ options: settings, transport, requests, sequence: planned, code: maker.code() }),
    notes: maker.notes,
  };
}

/** Names of routines and texts that all requests share. */
const SHARED: readonly Name[] = [
  'crc',
  'lrc',
  'digit value',
  'byte of digits',
  'digit of',
  'exception name',
  'fault name',
  'reply wanted',
  'bcd value',
  'float of parts',
];

/** A name as it was typed, as words: what is no letter or digit stays. */
const typedWords = (text: string): string =>
  text
    .replace(/([a-z\d])([A-Z])/g, '$1 $2')
    .replace(/[\s_-]+/g, ' ')
    .trim()
    .toLowerCase();

class PlanMaker {
  readonly notes: ProgramNote[] = [];
  readonly #transport: Transport;
  readonly #settings: Settings;
  readonly #names = new Set<Name>(SHARED);
  readonly #tables: Table[] = [];
  readonly #routines: Routine[] = [];

  constructor(transport: Transport, settings: Settings) {
    this.#transport = transport;
    this.#settings = settings;
  }

  request({ name: wanted, request: input }: AskedRequest): PlannedRequest {
    const { profile, part } = this.#settings;
    const bytes = bytesOf(input);
    const { transport } = input;
    const reading = decodeFrame(bytes, { transport, direction: input.direction });
    const called = this.#nameOf(wanted, reading);
    const about = aboutRequest(reading, profile);
    const rows = rowsOf(reading, bytes, profile);
    const table = `${called} frame`;
    const why = whyConstant(reading);
    if (why !== undefined) this.notes.push({ code: 'constant', request: called, why });
    const build = part === 'bytes' || why !== undefined ? undefined : this.#build(called, reading, about);
    if (build === undefined)
      this.#tables.push({ name: table, type: 'byte', values: [...bytes], base: 16, comment: about, rows });
    const planned = {
      name: called,
      input,
      bytes,
      reading,
      about,
      table: build === undefined ? table : undefined,
      rows,
      build: build?.name,
      arguments: build?.arguments ?? [],
      values: [],
    };
    if ((part !== 'check' && part !== 'exchange') || !isAnswered(reading)) {
      return { ...planned, check: undefined, list: undefined, wanted: undefined };
    }
    const checked = this.#check(called, reading, bytes);
    return { ...planned, ...checked, values: this.#values(called, reading, checked.list?.size ?? 0) };
  }

  /** The name of a request: as its user calls it, or what it does. */
  #nameOf(wanted: string | undefined, reading: Reading): Name {
    const own = wanted === undefined ? '' : plainWords(wanted);
    const valid = /^\d/.test(own) ? `frame ${own}` : own;
    const called = fresh(this.#names, valid === '' ? requestName(reading, this.#settings.profile) : valid);
    if (wanted !== undefined && called !== typedWords(wanted))
      this.notes.push({ code: 'name-changed', from: wanted, to: called });
    for (const of of [`build ${called}`, `check ${called}`, `${called} wanted`, `${called} frame`]) this.#names.add(of);
    return called;
  }

  /** The steps of a sequence, with the requests that they send and read with. */
  sequence({ steps, finally: last }: Sequence, requests: readonly PlannedRequest[]): PlannedSequence {
    const context = {
      requests,
      transport: this.#transport,
      free: (wanted: Name) => fresh(this.#names, wanted),
      add: (routine: Routine) => this.#routines.push(routine),
    };
    return { steps: plannedSteps(steps, context), finally: plannedSteps(last, context) };
  }

  #build(called: Name, reading: Reading, about: string) {
    const envelope = envelopes[this.#transport];
    const built = building(
      reading,
      envelope,
      `build ${called}`,
      [`Builds a request ${functionText(reading)}. Here:`, about],
      (field) => parameterText(reading, field),
    );
    for (const field of built.constant)
      this.notes.push({ code: 'constant', request: called, why: 'too-many-numbers', field });
    const given = this.#inUnits(called, reading, built.arguments);
    this.#routines.push(built.routine);
    return { name: built.routine.name, arguments: given };
  }

  #check(
    called: Name,
    reading: Reading,
    bytes: Uint8Array,
  ): Pick<PlannedRequest, 'check' | 'list' | 'items' | 'wanted'> {
    const envelope = envelopes[this.#transport];
    const wanted = this.#transport === 'rtu' ? `${called} wanted` : 'reply wanted';
    const request = new RequestBytes(reading, bytes, envelope);
    const { routine, list, items } = checking(request, envelope, `check ${called}`, wanted, `${called} items`);
    // Only an exchange, and the check of a binary frame, ask how long the reply is.
    const exchanges = this.#settings.part === 'exchange';
    const asks = exchanges || usedBy(routine).has(wanted);
    if (asks && !this.#routines.some(({ name }) => name === wanted))
      this.#routines.push(wantedRoutine(reading, envelope, wanted));
    this.#routines.push(routine);
    if (items === undefined || !exchanges) return { check: routine.name, list, wanted };
    this.#routines.push(items);
    const takes = (['reply', 'reply length'] as const).filter((one) =>
      items.parameters.some(({ name }) => name === one),
    );
    return { check: routine.name, list, items: { routine: items.name, takes }, wanted };
  }

  /** What takes values out of a good reply. */
  #values(called: Name, reading: Reading, items: number): readonly ReplyValue[] {
    const { profile, units } = this.#settings;
    const envelope = envelopes[this.#transport];
    const free = (wanted: Name) => fresh(this.#names, wanted === called ? `${called} value` : wanted);
    const { takings, rawOnly } = takingsOf({ reading, envelope, profile, units, items, free });
    for (const name of rawOnly) this.notes.push({ code: 'raw-only', request: called, name });
    this.#routines.push(...takings.map(({ routine }) => routine));
    return takings.map(({ value }) => value);
  }

  readonly #toRaw = new Map<string, Name>();

  /** The arguments of a request with those of its registers that are given in units. */
  #inUnits(called: Name, reading: Reading, given: readonly BuildArgument[]): readonly BuildArgument[] {
    const { profile, units } = this.#settings;
    if (!units || profile === undefined) return given;
    const written = writtenValues(reading, profile);
    for (const { name } of written.filter(({ scale }) => scale === undefined))
      this.notes.push({ code: 'raw-only', request: called, name });
    return given.map((argument) => {
      const mine = written.filter(({ field }) => wordsOf(field) === argument.parameter.name);
      const scaled = mine.flatMap(({ index, scale, raw }) =>
        scale === undefined
          ? []
          : [{ index, routine: this.#toRawOf(scale), value: typedInUnits(raw, scale.scale), unit: scale.unit }],
      );
      return scaled.length === 0 ? argument : { ...argument, scaled };
    });
  }

  /** The routine from units to raw; one for all values of one scale. */
  #toRawOf(scale: UnitScale): Name {
    const key = scaleKey(scale);
    const found = this.#toRaw.get(key);
    if (found !== undefined) return found;
    const routine = fresh(this.#names, `${unitWords(scale.unit)} to raw`);
    this.#toRaw.set(key, routine);
    this.#routines.push(toRawRoutine(scale, routine));
    return routine;
  }

  /** All parts in the order in which they need each other. */
  code(): Code {
    const used = new Set(this.#routines.flatMap((routine) => [...usedBy(routine)]));
    const { digitOf, reading, lrc } = asciiRoutines;
    const crc = used.has('crc') ? crcWays[this.#settings.crc]() : { tables: [], routines: [] };
    const characters =
      used.has('lrc') || used.has('byte of digits')
        ? [...reading, ...(used.has('lrc') ? [lrc] : []), ...(used.has('digit of') ? [digitOf] : [])]
        : [];
    const checks = [...used].some((name) => name.startsWith('fault '));
    const texts: readonly Texts[] = checks ? [exceptionTexts, faultTexts(used)] : [];
    return {
      constants: faultConstants(used),
      tables: [...crc.tables, ...this.#tables],
      texts,
      routines: [
        ...crc.routines,
        ...characters,
        ...numberRoutines.filter(({ name }) => used.has(name)),
        ...this.#routines,
      ],
    };
  }
}

/** Why a request is written as constant bytes; `undefined` if it is built. */
function whyConstant({ direction, outcome, forced, description }: Reading): string | undefined {
  if (direction === 'response') return 'reply';
  if (description === rawFunction) return 'raw';
  if (outcome.kind !== 'whole') return 'broken';
  return Object.keys(forced).length > 0 ? 'forced' : undefined;
}

/** Whether a reply is expected, and something is known of it. */
function isAnswered(reading: Reading): boolean {
  const { transport, direction, outcome, unitId, functionCode, description } = reading;
  if (direction === 'response' || transport === 'pdu' || outcome.kind !== 'whole') return false;
  if (functionCode === undefined || description === undefined || reading.forced['characters'] !== undefined)
    return false;
  return !(unitId === BROADCAST && transport !== 'tcp') && !isSilent(reading);
}
