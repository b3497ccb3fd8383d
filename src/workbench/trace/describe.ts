import { type EntityTable, type NamedValue, namedValues, type Profile } from '../../devices/index.ts';
import { describeFunction, hexDigits } from '../../modbus/index.ts';
import type { Trace, TraceCause, TraceStatistics } from '../../trace/index.ts';
import type { Described, Touched } from './filter.ts';
import type { FilterKnown } from './filter-completions.ts';
import { faultWords } from './filter-term.ts';
import type { RowUnit } from './messages.ts';
import { type ReaderClock, type TraceSpan, writtenMoment } from './moment.ts';
import { exchangeRowOf, rowOf, SHOWN, type TraceRow, valuesIn } from './row.ts';
import { type SeenFault, seenCounts, seenFault } from './seen-fault.ts';

const UTC: ReaderClock = () => 0;

/** What a filter is given beside the trace. */
export interface DescribeOptions {
  readonly profile?: Profile | undefined;
  readonly causes?: readonly TraceCause[];
  /** The sentence of a row, of what its frames say and not of when; without it, `text:` finds nothing. */
  readonly says?: ((row: TraceRow) => string) | undefined;
  readonly clock?: ReaderClock | undefined;
}

/**
 * What a filter asks of the frames or exchanges of a trace: of one after another, which `at` names. What stands in columns is read there, and
 * a frame is decoded only if something asks for its values or its sentence.
 */
export class Describer implements Described {
  readonly by: RowUnit;
  readonly #trace: Trace;
  readonly #options: DescribeOptions;
  readonly #causes: readonly (readonly [code: string, exchanges: ReadonlySet<number>])[];
  readonly #sentences = new Map<string, string>();
  #index = 0;
  /** Made once for each size of the trace. */
  #span: TraceSpan | undefined;
  #spanOf = -1;
  #exchange = 0;

  constructor(trace: Trace, by: RowUnit, options: DescribeOptions = {}) {
    this.#trace = trace;
    this.by = by;
    this.#options = options;
    this.#causes = (options.causes ?? []).map(({ code, exchanges }) => [code, new Set(exchanges)] as const);
  }

  /** The frame or exchange that is asked about from now on. */
  at(index: number): this {
    this.#index = index;
    this.#exchange = this.by === 'frame' ? this.#trace.exchangeOf(index) : index;
    return this;
  }

  get unit(): number {
    return this.#trace.subject(this.#exchange).unit;
  }

  get functionCode(): number {
    return this.#trace.subject(this.#exchange).functionCode;
  }

  get isFrame(): boolean {
    return this.#trace.pieces === 0 || !this.#trace.isPiece(this.#exchange);
  }

  get faults(): readonly SeenFault[] {
    return this.#faults.map(seenFault);
  }

  get #faults() {
    const faults = this.#trace.faults(this.#exchange);
    if (faults.length === 0 || this.by === 'exchange') return faults;
    return faults.filter(({ records }) => records.at(-1) === this.#index);
  }

  get exception(): number | undefined {
    const found = this.#faults.find(({ kind }) => kind === 'exception')?.['exception'];
    return typeof found === 'number' ? found : undefined;
  }

  get causes(): readonly string[] {
    return this.#causes.flatMap(([code, exchanges]) => (exchanges.has(this.#exchange) ? [code] : []));
  }

  get after(): number | undefined {
    const [exchange] = this.#trace.exchanges(this.#exchange, this.#exchange + 1);
    return this.by === 'exchange' || exchange?.replies.includes(this.#index) ? exchange?.after : undefined;
  }

  get time(): number | undefined {
    return this.#trace.time(this.#record);
  }

  /** The first record of what is described. */
  get #record(): number {
    const [first = 0] = this.by === 'frame' ? [this.#index] : this.#records;
    return first;
  }

  get span(): TraceSpan | undefined {
    const { size } = this.#trace;
    if (this.#spanOf === size) return this.#span;
    const { span } = this.#trace;
    this.#spanOf = size;
    this.#span = span && { ...span, clock: this.#options.clock ?? UTC };
    return this.#span;
  }

  get touched(): readonly Touched[] {
    const { functionCode, address, quantity } = this.#trace.subject(this.#exchange);
    if (address === undefined) return [];
    const { table, access } = describeFunction(functionCode, 'request');
    if (table === 'file-record') return [];
    const first: Touched = { table, first: address, last: address + Math.max(quantity, 1) - 1 };
    if (access !== 'reads-and-writes') return [first];
    const [record = 0] = this.#records;
    const written = this.#trace.spoken(record).side === 'request' ? valuesIn(this.#trace, record) : undefined;
    return written
      ? [first, { table, first: written.first, last: written.first + written.values.length - 1 }]
      : [first];
  }

  get connection(): string {
    return this.#trace.spoken(this.#record).connection ?? '';
  }

  get values(): readonly number[] {
    const { profile } = this.#options;
    if (!this.isFrame) return [];
    const { functionCode } = this.#trace.subject(this.#exchange);
    const { table } = describeFunction(functionCode, 'request');
    if (table === undefined || table === 'file-record') return [];
    const records = this.by === 'frame' ? [this.#index] : this.#records;
    return records.flatMap((record) => {
      const list = valuesIn(this.#trace, record);
      return list ? inUnits(list.first, list.values, table, profile) : [];
    });
  }

  /** Those of the exchange. */
  get #records(): readonly number[] {
    const [exchange] = this.#trace.exchanges(this.#exchange, this.#exchange + 1);
    return exchange === undefined
      ? []
      : [...(exchange.request === undefined ? [] : [exchange.request]), ...exchange.replies];
  }

  get sentence(): string {
    const content = this.#content;
    let text = content === undefined ? undefined : this.#sentences.get(content);
    if (text === undefined) {
      const { says, profile } = this.#options;
      const row = (this.by === 'frame' ? rowOf : exchangeRowOf)(this.#trace, this.#index, profile);
      text = withPlainNumbers(says?.(row).toLowerCase() ?? '');
      if (this.#sentences.size >= MOST_SENTENCES) this.#sentences.clear();
      if (content !== undefined) this.#sentences.set(content, text);
    }
    return text;
  }

  get hex(): string {
    const trace = this.#trace;
    const [request, reply] = [trace.requestOf(this.#exchange), trace.replyOf(this.#exchange)];
    if (this.by === 'frame') return `${hexText(trace.bytes(this.#index))} `;
    if (request === undefined) return `${hexText(trace.bytes(reply ?? 0))} `;
    return `${hexText(trace.bytes(request))} ${reply === undefined ? '' : hexText(trace.bytes(reply))}`;
  }

  /** All that decides what a row says, which is the same for many; `undefined` where that would be long. */
  get #content(): string | undefined {
    const trace = this.#trace;
    const request = trace.requestOf(this.#exchange);
    const record = this.by === 'frame' ? this.#index : (request ?? trace.replyOf(this.#exchange) ?? 0);
    const other = record === request && this.by === 'exchange' ? trace.replyOf(this.#exchange) : request;
    const wrong = trace.faults(this.#exchange);
    const known = trace.known(record) ?? (other === undefined ? undefined : trace.known(other));
    // What is known is rare, and so is what is long.
    if (known !== undefined) return undefined;
    const own = contentOf(trace, record);
    const others = other === undefined || other === record ? '' : contentOf(trace, other);
    if (own === undefined || others === undefined) return undefined;
    const remarks =
      wrong.length === 0
        ? ''
        : JSON.stringify(this.#faults.map(({ kind, code, exception }) => [kind, code, exception]));
    return `${own}${others.length} ${others}${remarks}`;
  }
}

const TRAILING_ZEROS = /(\d\.\d*?)0+(?!\d)/g;

/** A text, and the same with `30` for `30.0`, as somebody writes it who looks for it. */
export function withPlainNumbers(text: string): string {
  const plain = text.replace(TRAILING_ZEROS, (_, number: string) =>
    number.endsWith('.') ? number.slice(0, -1) : number,
  );
  return plain === text ? text : `${plain} ${text}`;
}

/** Sentences that are kept while others are made. */
const MOST_SENTENCES = 20_000;
const MOST_CONTENT = 512;
const TRANSACTION = 2;
const PAIRS = Array.from({ length: 256 }, (_, byte) => hexDigits(byte, 2).toLowerCase());

/** What decides what a frame says: how it is carried, its side, and its bytes but for the transaction. */
function contentOf(trace: Trace, record: number): string | undefined {
  const bytes = trace.bytes(record);
  if (bytes.length > MOST_CONTENT) return undefined;
  const transport = trace.transport(record);
  const from = transport === 'tcp' ? TRANSACTION : 0;
  return `${transport}${trace.side(record)}${String.fromCharCode.apply(null, bytes.subarray(from) as unknown as number[])}`;
}

function hexText(bytes: Uint8Array): string {
  const end = Math.min(bytes.length, SHOWN);
  let text = end === 0 ? '' : (PAIRS[bytes[0] as number] as string);
  for (let at = 1; at < end; at++) text += ` ${PAIRS[bytes[at] as number]}`;
  return text;
}

/** The values of a list: in units those that the device names, and the others as they are. */
function inUnits(
  first: number,
  list: readonly number[],
  table: EntityTable,
  profile: Profile | undefined,
): readonly number[] {
  const named = profile ? namedValues(profile, table, first, list) : [];
  if (named.length === 0) return list;
  const taken = new Set(named.flatMap(({ at, size }) => Array.from({ length: size }, (_, into) => at + into)));
  return [...named.flatMap(ownValue), ...list.filter((_, at) => !taken.has(at))];
}

function ownValue({ scaled, raw }: NamedValue): readonly number[] {
  const value = scaled ?? raw;
  return typeof value === 'number' || typeof value === 'bigint' ? [Number(value)] : [];
}

/** Addresses that are offered at most. */
const MOST_ADDRESSES = 5000;

/** What occurs in a trace, for the completion of a filter. */
export function filterKnown(
  trace: Trace,
  statistics: TraceStatistics,
  causes: readonly Pick<TraceCause, 'code' | 'explained'>[],
  clock: ReaderClock = UTC,
): FilterKnown {
  const exceptions = new Map<number, number>();
  const units = statistics.by('unit');
  for (const tally of units)
    for (const [code, count] of tally.exceptions) exceptions.set(code, (exceptions.get(code) ?? 0) + count);
  const addresses = new Map<string, FilterKnown['addresses'][number]>();
  for (const { functionCode = 0, address, exchanges } of statistics.by('address')) {
    const { table } = describeFunction(functionCode, 'request');
    if (address === undefined || table === 'file-record') continue;
    const key = `${table} ${address}`;
    addresses.set(key, { table, value: address, count: exchanges + (addresses.get(key)?.count ?? 0) });
  }
  const ends = new Map<string, number>();
  for (const { connection = '', exchanges } of statistics.by('connection')) {
    // An end that has a space would have to be written in quotes.
    for (const end of connection.split(' → ').filter((one) => /^[^\s",]+$/.test(one)))
      ends.set(end, exchanges + (ends.get(end) ?? 0));
  }
  const faults = seenCounts(trace.summary(), trace.pieces);
  const { span } = trace;
  const read = span && { ...span, clock };
  return {
    units: units.map(({ unit = 0, exchanges }) => ({ value: unit, count: exchanges })),
    functionCodes: statistics
      .by('function')
      .map(({ functionCode = 0, exchanges }) => ({ value: functionCode, count: exchanges })),
    exceptions: [...exceptions].sort(([one], [other]) => one - other).map(([value, count]) => ({ value, count })),
    addresses: [...addresses.values()].sort((one, other) => one.value - other.value).slice(0, MOST_ADDRESSES),
    faults: [...faultWords].flatMap(([word, kind]) => {
      const count = kind === 'any' ? 0 : (faults.get(kind) ?? 0);
      return count > 0 && word !== 'checksum' ? [{ word, count }] : [];
    }),
    causes: causes.map(({ code, explained }) => ({ code, count: explained })),
    ends: [...ends].map(([text, count]) => ({ text, count })),
    times: read ? [...new Set([read.first, read.last].map((time) => writtenMoment(read, time)))] : [],
  };
}
