import { type Direction, decodeFrame } from '../modbus/index.ts';
import { type Candidate, judgement } from './candidate.ts';

// Likelihoods are roughly bits: what speaks for a frame is positive, and what adds up to more is more likely. They are
// whole numbers, so that equal evidence is equal.

/**
 * The evidence for a frame by itself. One window in 65536 passes its CRC by chance; a chance hit rarely keeps all rules too,
 * so a frame that breaks rules needs its neighbours as evidence.
 */
const OWN = { legal: 4, warned: -1, illegal: -3 } as const;
/** The frame adjoins a neighbour, or the beginning or the end of the stream. */
const ADJOINS = 4;

/** The evidence, for both, of a frame right behind another, by the direction of each. */
const FOLLOWS = {
  /** A reply to the request before it. */
  answer: 5,
  /** The same function and unit, but not what was asked for. */
  misfit: 0,
  /** A reply to another request. */
  foreign: -1,
  /** The next request, once the one before was answered. */
  nextRequest: 2,
  /** A request that was not answered: a time-out, or a broadcast. */
  unanswered: 1,
  broadcast: 3,
  /** Two replies to one request. */
  secondReply: -1,
} as const;

const BROADCAST = 0;
const EXCEPTION = 0x80;

/** The evidence for a candidate by itself, in the direction that breaks fewer rules. */
export function likelihood(bytes: Uint8Array, frame: Candidate, adjoins: boolean): number {
  let best: number = OWN.illegal;
  for (const direction of frame.directions) best = Math.max(best, OWN[judgement(bytes, frame, direction)]);
  return adjoins ? best + ADJOINS : best;
}

/** How likely a candidate is, given that it begins where another ends, in the directions that fit best. */
export function succession(bytes: Uint8Array, before: Candidate, after: Candidate): number {
  let best: number = FOLLOWS.foreign;
  for (const first of before.directions) {
    for (const second of after.directions) best = Math.max(best, link(bytes, before, first, after, second));
  }
  return best;
}

/**
 * How likely a frame is in this direction, given that it begins where another ends, in its direction. A reply from the
 * server that was asked is assumed to be the one that was asked for; this is checked only if it may not be a reply at all.
 */
export function link(
  bytes: Uint8Array,
  before: Candidate,
  first: Direction,
  after: Candidate,
  second: Direction,
): number {
  if (second === 'response') {
    if (first === 'response') return FOLLOWS.secondReply;
    if (!sameServer(bytes, before, after)) return FOLLOWS.foreign;
    return after.directions.length === 1 || answers(bytes, before, after) ? FOLLOWS.answer : FOLLOWS.misfit;
  }
  if (first === 'response') return FOLLOWS.nextRequest;
  return before.transport === 'rtu' && bytes[before.from] === BROADCAST ? FOLLOWS.broadcast : FOLLOWS.unanswered;
}

/** The places of the unit identifier and the function code. */
const HEAD = { rtu: { at: 0, unit: 1 }, tcp: { at: 6, unit: 1 }, ascii: { at: 1, unit: 2 } } as const;

/** Whether a reply comes from the unit and the function of the request; as an exception too. */
function sameServer(bytes: Uint8Array, request: Candidate, reply: Candidate): boolean {
  const { at, unit } = HEAD[request.transport];
  const asked = request.from + at;
  const got = reply.from + at;
  for (let i = 0; i < unit; i++) if (bytes[asked + i] !== bytes[got + i]) return false;
  // In characters the exception bit is in the first digit.
  if (unit === 2) return bytes[asked + 3] === bytes[got + 3];
  return bytes[asked + unit] === ((bytes[got + unit] as number) & ~EXCEPTION);
}

/** Whether a reply is what the request asked for: its echo, or a reply that breaks no rule about its request. */
function answers(bytes: Uint8Array, request: Candidate, reply: Candidate): boolean {
  if (same(bytes, request, reply)) return true;
  const { problems } = decodeFrame(bytes.subarray(reply.from, reply.to), {
    transport: request.transport,
    direction: 'response',
    request: bytes.subarray(request.from, request.to),
  });
  return !problems.some(({ code, severity }) => severity === 'error' && AGAINST_REQUEST.has(code));
}

const AGAINST_REQUEST: ReadonlySet<string> = new Set([
  'echo-differs',
  'count-not-as-requested',
  'transaction-not-as-requested',
]);

function same(bytes: Uint8Array, a: Candidate, b: Candidate): boolean {
  const length = a.to - a.from;
  if (b.to - b.from !== length) return false;
  for (let i = 0; i < length; i++) if (bytes[a.from + i] !== bytes[b.from + i]) return false;
  return true;
}
