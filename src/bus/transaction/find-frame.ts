import {
  BROADCAST,
  decodeFrame,
  type FrameAt,
  framesAt,
  nextPlace,
  type Reading,
  type SerialMode,
  sameBytes,
} from '../../modbus/index.ts';

/** What is waited for: a frame of this unit and function, whose fields fit the request. */
export interface Awaited {
  readonly transport: SerialMode;
  readonly request: Uint8Array;
  readonly asked: Reading;
}

/** A frame among what has come, the bytes `[from, to)`. */
export type Found =
  /** Of the unit that was asked. */
  | { readonly kind: 'ours'; readonly from: number; readonly to: number }
  /** Of another unit, or a request. */
  | { readonly kind: 'other'; readonly from: number; readonly to: number };

const EXCEPTION = 0x80;
const COLON = 0x3a;
/** Fewer bytes are not a frame (SL 2.5.1). */
const LEAST_RTU = 4;

/**
 * The first whole frame in bytes that may not all be there yet; `ended` says that a silence has followed them. What may
 * still grow into the reply is waited for, and a frame whose length no byte tells until it is the request again, or until
 * the silence.
 */
export function findFrame(bytes: Uint8Array, awaited: Awaited, ended: boolean): Found | undefined {
  const { transport } = awaited;
  const next = (from: number) => (transport === 'ascii' ? nextPlace(bytes, from, 'ascii') : from);
  for (let at = next(0); at < bytes.length; at = next(at + 1)) {
    const frames = framesAt(bytes, at, bytes.length, transport);
    const ours = frames.filter(
      (frame) => frame.direction === 'response' && unitAt(bytes, at, frame) === awaited.asked.unitId,
    );
    const settled = ours.filter((frame) => ended || isSettled(bytes, frame, awaited));
    const fitting = settled.length > 1 && settled.find(({ from, to }) => fits(bytes.subarray(from, to), awaited));
    const best = fitting || settled[0];
    if (best !== undefined) return { kind: 'ours', from: best.from, to: best.to };
    if (ours.length > 0 || (!ended && mayGrow(bytes, at, awaited))) return undefined;
    const other = frames.find(({ open }) => ended || !open);
    if (other !== undefined) return { kind: 'other', from: other.from, to: other.to };
  }
  return undefined;
}

/** The first frame of any unit and direction. */
export function anyFrame(bytes: Uint8Array, transport: SerialMode): { from: number; to: number } | undefined {
  const next = (from: number) => (transport === 'ascii' ? nextPlace(bytes, from, 'ascii') : from);
  for (let at = next(0); at < bytes.length; at = next(at + 1)) {
    const [frame] = framesAt(bytes, at, bytes.length, transport);
    if (frame !== undefined) return frame;
  }
  return undefined;
}

/** Whether the bytes are a whole reply to the request in which nothing is wrong. */
export const fits = (bytes: Uint8Array, { transport, request }: Pick<Awaited, 'transport' | 'request'>): boolean =>
  isSound(decodeFrame(bytes, { transport, direction: 'response', request }));

/** Whether a frame is whole and breaks no rule. */
export const isSound = ({ outcome, problems }: Reading): boolean =>
  outcome.kind === 'whole' && problems.every(({ severity }) => severity !== 'error');

/** Whether a frame has the function that was asked for, or is its exception. */
export const hasFunction = ({ functionCode }: Reading, asked: Reading): boolean =>
  functionCode !== undefined && asked.functionCode !== undefined && sameCode(functionCode, asked.functionCode);

/** Whether these bytes, which are not a frame, begin as the reply does. */
export const startsAsReply = (bytes: Uint8Array, { asked }: Awaited): boolean =>
  bytes[0] === asked.unitId &&
  bytes[1] !== undefined &&
  asked.functionCode !== undefined &&
  sameCode(bytes[1], asked.functionCode);

/** Whether these bytes, which are not a frame, look as if they were meant to be the reply. */
export function mayBeReply(bytes: Uint8Array, { transport, asked }: Awaited): boolean {
  if (transport === 'ascii') return bytes.includes(COLON);
  const { unitId, functionCode } = asked;
  const unit = (at: number) => bytes[at] === unitId;
  const code = (at: number) =>
    functionCode !== undefined && bytes[at] !== undefined && sameCode(bytes[at], functionCode);
  if (bytes.some((_, at) => unit(at) && code(at + 1))) return true;
  return bytes.length >= LEAST_RTU && (unit(0) || code(1));
}

const sameCode = (one: number, other: number) => ((one ^ other) & ~EXCEPTION) === 0;

const unitAt = (bytes: Uint8Array, at: number, { transport, from, to }: FrameAt): number | undefined =>
  transport === 'rtu' ? bytes[at] : decodeFrame(bytes.subarray(from, to), { transport, direction: 'response' }).unitId;

/** Whether the frame ends where it seems to, although nothing is known of what follows. */
const isSettled = (bytes: Uint8Array, { transport, open, from, to }: FrameAt, { request }: Awaited): boolean =>
  transport === 'ascii' || !open || sameBytes(bytes.subarray(from, to), request);

/** Whether what begins here is the beginning of a reply of the unit and function that were asked. */
function mayGrow(bytes: Uint8Array, at: number, { transport, asked }: Awaited): boolean {
  if (transport === 'ascii' || bytes[at] !== asked.unitId) return false;
  const code = bytes[at + 1];
  if (code === undefined) return true;
  if (asked.functionCode === undefined || !sameCode(code, asked.functionCode)) return false;
  const { outcome, open } = decodeFrame(bytes.subarray(at), { transport, direction: 'response' });
  return outcome.kind === 'short' || open;
}

/** Why no reply to a request is due; `undefined` if one is. */
export function unansweredBy({ asked, request, transport }: Awaited): 'broadcast' | 'no-reply' | undefined {
  if (asked.unitId === BROADCAST) return 'broadcast';
  // A request without a reply exists only if a sub-function decides what is answered.
  if (asked.description?.response.then === undefined) return undefined;
  const { problems } = decodeFrame(request, { transport, direction: 'response' });
  return problems.some(({ code }) => code === 'sub-function-without-reply') ? 'no-reply' : undefined;
}
