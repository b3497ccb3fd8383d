import { decodeFrame, type FrameAt } from '../modbus/index.ts';

// Likelihoods are roughly bits: what speaks for a frame is positive, and what adds up to more is more likely. They are
// whole numbers, so that equal evidence is equal.

/**
 * What a frame says for itself. One window in 65536 passes its CRC by chance; a chance hit rarely keeps all rules too,
 * so one that breaks them needs neighbours to speak for it.
 */
const OWN = { legal: 4, warned: -1, illegal: -3 } as const;
/** A reply that comes from the broadcast address. */
const BROADCAST_REPLY = -4;
/** Nothing is lost between the frame and the beginning or the end of the stream. */
const AT_EDGE = 2;

/** What one frame right behind another says for both. */
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

export function likelihood(bytes: Uint8Array, { transport, direction, from, to, legal, warned }: FrameAt): number {
  let bits: number = legal ? (warned ? OWN.warned : OWN.legal) : OWN.illegal;
  if (transport === 'rtu' && direction === 'response' && bytes[from] === BROADCAST) bits += BROADCAST_REPLY;
  if (from === 0) bits += AT_EDGE;
  if (to === bytes.length) bits += AT_EDGE;
  return bits;
}

/** How likely `after` is, given that it begins where `before` ends. */
export function succession(bytes: Uint8Array, before: FrameAt, after: FrameAt): number {
  if (after.direction === 'response') {
    if (before.direction === 'response') return FOLLOWS.secondReply;
    if (!sameServer(bytes, before, after)) return FOLLOWS.foreign;
    return answers(bytes, before, after) ? FOLLOWS.answer : FOLLOWS.misfit;
  }
  if (before.direction === 'response') return FOLLOWS.nextRequest;
  return before.transport === 'rtu' && bytes[before.from] === BROADCAST ? FOLLOWS.broadcast : FOLLOWS.unanswered;
}

/** Where unit identifier and function code stand, and their length. */
const HEAD = { rtu: { at: 0, unit: 1 }, tcp: { at: 6, unit: 1 }, ascii: { at: 1, unit: 2 } } as const;

/** Whether a reply comes from the unit and the function of the request; as an exception too. */
function sameServer(bytes: Uint8Array, request: FrameAt, reply: FrameAt): boolean {
  const { at, unit } = HEAD[request.transport];
  const asked = request.from + at;
  const got = reply.from + at;
  for (let i = 0; i < unit; i++) if (bytes[asked + i] !== bytes[got + i]) return false;
  if (unit === 2) return bytes[asked + 3] === bytes[got + 3];
  return ((bytes[asked + unit] as number) ^ ((bytes[got + unit] as number) & ~EXCEPTION)) === 0;
}

/** Whether a reply is what the request asked for: its echo, or under the rules of a reply against its request. */
function answers(bytes: Uint8Array, request: FrameAt, reply: FrameAt): boolean {
  if (same(bytes, request, reply)) return true;
  const { transport } = request;
  const { problems } = decodeFrame(bytes.subarray(reply.from, reply.to), {
    transport,
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

function same(bytes: Uint8Array, a: FrameAt, b: FrameAt): boolean {
  const length = a.to - a.from;
  if (b.to - b.from !== length) return false;
  for (let i = 0; i < length; i++) if (bytes[a.from + i] !== bytes[b.from + i]) return false;
  return true;
}
