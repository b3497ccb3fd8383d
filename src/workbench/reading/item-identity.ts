import { type Identity, identify } from '../../diagnosis/index.ts';
import type { Transport } from '../../modbus/index.ts';
import type { PastedItem, TextReading } from './read-text.ts';

/** What an item of a text may be. */
export interface ItemIdentity {
  readonly bytes: Uint8Array;
  /** The request that it answers, or was to answer. */
  readonly request: Uint8Array | undefined;
  /** What answers it. */
  readonly reply: Uint8Array | undefined;
  /** The pieces of the text on either side, which say something about it. */
  readonly preceding: readonly Uint8Array[];
  readonly following: readonly Uint8Array[];
  /** The likeliest first. */
  readonly identities: readonly Identity[];
}

/** Pieces on either side. */
const PIECES = 4;
/** The reply to a frame stands within so many pieces behind it. */
const REPLY_WITHIN = 64;

/** The item that is shown when a text was read: its first frame, or else its first bytes. */
export const firstFrame = ({ items }: TextReading): number =>
  Math.max(
    0,
    items.findIndex(({ kind }) => kind === 'frame'),
  );

/** What an item may be, and the request that it answers; `undefined` if there is no such item. */
export function identityOf({ items, bytes }: TextReading, index: number): ItemIdentity | undefined {
  const item = items[index];
  if (item === undefined) return undefined;
  const own = bytes.slice(item.from, item.to);
  const asked = askedBefore(items, index);
  const request = asked && bytes.slice(asked.from, asked.to);
  const { transport, direction = undefined } = item.kind === 'frame' ? item : { transport: undefined };
  const pieces = (from: number, to: number) =>
    items.slice(Math.max(0, from), to).map((one) => bytes.slice(one.from, one.to));
  const reply = items
    .slice(index + 1, index + 1 + REPLY_WITHIN)
    .find((other) => other.kind === 'frame' && other.answers === index);
  return {
    bytes: own,
    request,
    reply: reply && bytes.slice(reply.from, reply.to),
    preceding: pieces(index - PIECES, index),
    following: pieces(index + 1, index + 1 + PIECES),
    identities: identify(own, { transport, direction, request }),
  };
}

/** The request that an item answers; if it is not a sound answer, the request that waits for a reply when it comes. */
function askedBefore(items: readonly PastedItem[], index: number): PastedItem | undefined {
  const item = items[index] as PastedItem;
  if (item.kind === 'frame' && item.answers !== undefined) return items[item.answers];
  const failed = item.said === 'response' || item.kind === 'unread' || item.severity === 'error';
  if (item.said === 'request' || !failed) return undefined;
  for (let before = index - 1; before >= 0; before--) {
    const other = items[before] as PastedItem;
    if (other.kind === 'unread') continue;
    return other.direction === 'request' && other.said !== 'response' ? other : undefined;
  }
  return undefined;
}

/** What the text of an item tells of its bytes, which somebody takes for those of a transport. */
export function itemContext({ request, preceding, following, identities }: ItemIdentity, transport: Transport) {
  return {
    // A transport that was guessed from the bytes says nothing more about them.
    transport: transport === identities[0]?.transport ? undefined : transport,
    ...(request && { request }),
    preceding,
    following,
  };
}
