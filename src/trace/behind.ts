import { decodeFrame } from '../modbus/index.ts';
import type { Exchanges } from './exchanges.ts';
import type { Fault, FaultKind } from './fault.ts';
import { Held } from './held.ts';
import type { Asked } from './waiting.ts';

/** A frame of such a fault is not one of a unit; and where one is, its unit may be another than that of its exchange. */
const DAMAGED: ReadonlySet<FaultKind> = new Set(['checksum', 'broken']);
const UNSURE_UNIT: ReadonlySet<FaultKind> = new Set([...DAMAGED, 'mismatch']);

/**
 * What a trace holds of the records from one on, with the requests that wait. Nothing is decoded again but what may be of another
 * unit than its exchange; an exchange that began before keeps what belongs to it of the records that stay.
 */
export function heldBehind(all: Held, first: number): Held {
  const rest = new Held(all.records.behind(first));
  const numbers = new Map<number, number>();
  for (let at = first; at < all.records.size; at++) {
    rest.noteTime(all.records.time(at));
    const exchange = all.exchangeOf.at(at);
    let number = numbers.get(exchange);
    if (number === undefined) {
      const { exchanges } = all;
      const [replies, faults] = [exchanges.replies(exchange), exchanges.faults(exchange)];
      const before: Before = { exchange, request: exchanges.request(exchange), replies, faults, first };
      number = takeExchange(exchanges, before, rest.exchanges, at);
      numbers.set(exchange, number);
      noteTimes(all, before, rest);
      noteUnits(all, before, rest);
    }
    if (!all.isFrame(at)) rest.pieces++;
    rest.exchangeOf.push(number);
  }
  const renumbered = (asked: Asked): Asked | undefined => {
    const exchange = asked.record < first ? undefined : numbers.get(asked.exchange);
    return exchange === undefined ? undefined : { ...asked, exchange, record: asked.record - first };
  };
  const lines = rest.waiting.takeFrom(all.waiting, renumbered);
  for (const [exchange, before] of all.waitingLines) {
    const [number, line] = [numbers.get(exchange), lines.get(before)];
    if (number !== undefined && line) rest.waitingLines.set(number, line);
  }
  return rest;
}

/** An exchange of the trace that is cut, and the first record that stays. */
interface Before {
  readonly exchange: number;
  readonly request: number | undefined;
  readonly replies: readonly number[];
  readonly faults: readonly Fault[];
  readonly first: number;
}

/** Begins an exchange with what stays of one before, of whose records `at` is the first that stays; answers its number. */
function takeExchange(from: Exchanges, before: Before, into: Exchanges, at: number): number {
  const { exchange, request, replies, faults, first } = before;
  const kept = (records: readonly number[]) => records.filter((index) => index >= first).map((index) => index - first);
  const [reply, ...more] = kept(replies);
  const isAsked = request !== undefined && request >= first;
  const number = into.begin({
    // An echo belongs to a request that did not stay.
    request: isAsked ? request - first : reply === undefined ? at - first : undefined,
    reply,
    isSilent: !isAsked || from.isSilent(exchange),
    subject: from.subject(exchange),
  });
  for (const record of more) into.addReply(number, record);
  for (const fault of faults)
    if (fault.records.some((index) => index >= first))
      into.addFault(number, { ...fault, records: kept(fault.records) });
  return number;
}

/** Notes how long the replies of an exchange took whose request stays. */
function noteTimes({ records }: Held, { request, replies, faults, first }: Before, rest: Held): void {
  if (request === undefined || request < first) return;
  const sent = records.time(request) ?? Number.NaN;
  for (const reply of replies) {
    const isEcho = faults.some((fault) => fault.code === 'echo' && fault.records.includes(reply));
    if (!isEcho) rest.replyTimes.add((records.time(reply) ?? Number.NaN) - sent);
  }
}

/** Notes who speaks in the records of an exchange that stay and that a receiver takes. */
function noteUnits({ records, exchanges }: Held, before: Before, rest: Held): void {
  const { exchange, request, replies, faults, first } = before;
  const stays = (index: number) => index >= first && records.known(index)?.beside === undefined;
  if (faults.every(({ kind }) => !UNSURE_UNIT.has(kind))) {
    const isSpoken = (request !== undefined && stays(request)) || replies.some(stays);
    if (isSpoken) rest.units[exchanges.subject(exchange).unit] = 1;
    return;
  }
  const damaged = new Set(faults.flatMap(({ kind, records }) => (DAMAGED.has(kind) ? records : [])));
  for (const index of request === undefined ? replies : [request, ...replies]) {
    if (damaged.has(index) || !stays(index)) continue;
    const direction = records.side(index) ?? 'request';
    const { unitId = 0 } = decodeFrame(records.bytes(index), { transport: records.transport(index), direction });
    rest.units[unitId] = 1;
  }
}
