import { type Direction, decodeFrame, type Reading, type Transport } from '../../modbus/index.ts';
import { splitStream } from '../split-stream.ts';
import { type Reason, weightOf } from './reason.ts';
import { evidence, evidenceOfContext, type IdentifyContext, isFlawless } from './reasons-for.ts';

export type { IdentifyContext } from './reasons-for.ts';

/** What bytes may be. */
export interface Identity {
  readonly transport: Transport;
  readonly direction: Direction;
  /** The bytes read this way; a reply is read with its request if one is given. */
  readonly reading: Reading;
  /** What speaks for it and against it, the envelope first. */
  readonly reasons: readonly Reason[];
  /** The sum of the reasons, roughly in bits. Two identities of the same weight are equally likely. */
  readonly weight: number;
}

/** In the order in which they are offered if nothing else decides. */
export const TRANSPORTS = ['rtu', 'tcp', 'ascii', 'pdu'] as const satisfies readonly Transport[];
const DIRECTIONS = ['request', 'response'] as const satisfies readonly Direction[];

/** More bytes than any frame has (SL 2.5.2.1): no byte behind these tells what they are. */
export const MOST_LOOKED_AT = 1024;

/**
 * What bytes are, found from the bytes alone: transport and direction, the most likely first; never empty unless
 * the bytes are. A broken frame is said to be what it most probably was. If request and reply look the same, both stand
 * next to each other, in the order of the context. More bytes than a frame can have are read in one transport.
 * Never throws; takes time linear in the number of bytes.
 */
export function identify(bytes: Uint8Array, context: IdentifyContext = {}): readonly Identity[] {
  if (bytes.length === 0) return [];
  const start = bytes.subarray(0, MOST_LOOKED_AT);
  const found = TRANSPORTS.flatMap((transport) => inBothDirections(start, transport, context));
  // A function without fields is a whole PDU whatever follows its code.
  const whole = found.some(({ transport, reading }) => transport !== 'pdu' && isFlawless(reading));
  const ranked = byWeight(whole ? found : lookInside(found, start, context));
  const [best] = ranked;
  return best === undefined || start.length === bytes.length
    ? likely(ranked)
    : likely(rank(bytes, context, [best.transport]));
}

const likely = (ranked: readonly Identity[]) =>
  ranked.filter(({ weight }, i) => i === 0 || weight > 0 || weight === ranked[0]?.weight);

/** The bytes as one frame of these transports, in both directions, the most likely first. */
export const rank = (bytes: Uint8Array, context: IdentifyContext, transports: readonly Transport[]): Identity[] =>
  byWeight(transports.flatMap((transport) => inBothDirections(bytes, transport, context)));

const byWeight = (found: Identity[]) => found.sort((a, b) => b.weight - a.weight);

function inBothDirections(bytes: Uint8Array, transport: Transport, context: IdentifyContext): Identity[] {
  const readings = DIRECTIONS.map((direction) => decode(bytes, transport, direction, context));
  const own = readings.map((reading) => evidence(reading, bytes));
  const [asked = 0, answered = 0] = own.map(sum);
  const either: Reason[] = asked === answered && readings.every(isFlawless) ? [{ code: 'same-either-way' }] : [];
  return readings.map((reading, i) => {
    const reasons = [...(own[i] ?? []), ...either, ...evidenceOfContext(reading, bytes, context)];
    return { transport, direction: reading.direction, reading, reasons, weight: sum(reasons) };
  });
}

const decode = (bytes: Uint8Array, transport: Transport, direction: Direction, { request }: IdentifyContext) =>
  decodeFrame(bytes, { transport, direction, request });

const sum = (reasons: readonly Reason[]) => reasons.reduce((total, reason) => total + weightOf(reason), 0);

/** If a whole frame stands among stray bytes, its evidence counts for its transport. */
function lookInside(found: Identity[], bytes: Uint8Array, context: IdentifyContext): Identity[] {
  const frame = splitStream(bytes).find(({ kind }) => kind === 'frame');
  if (frame?.kind !== 'frame') return found;
  const { transport, from, to } = frame;
  const inside = inBothDirections(bytes.subarray(from, to), transport, context);
  return found.map((identity) => {
    const own = inside.find(({ direction }) => direction === identity.direction);
    if (identity.transport !== transport || own === undefined) return identity;
    const reasons: Reason[] = [{ code: 'frame-inside', from, to }, ...own.reasons];
    return { ...identity, reasons, weight: sum(reasons) };
  });
}
