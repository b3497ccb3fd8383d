import { type Reading, sameBytes, type Transport } from '../../../modbus/index.ts';
import { worst } from '../../../workbench/index.ts';
import { identityAt, pasted } from '../../parts/pasted.ts';

/** Pieces of the text looked at on either side. */
const PIECES = 4;

/** Frames that were pasted, and those with something to be said of. */
export const isAsked = ({ problems, outcome }: Reading, bytes: Uint8Array) =>
  outcome.kind !== 'whole' || ['error', 'warning'].includes(worst(problems) ?? '') || isPasted(bytes);

const isPasted = (bytes: Uint8Array) => fromText(bytes, undefined) !== undefined;

/** What the text the bytes were pasted with knows of them: the request before them, and the pieces on either side. */
export function fromText(bytes: Uint8Array, transport: Transport | undefined) {
  if (pasted.value.kind !== 'read') return undefined;
  const { reading, chosen } = pasted.value;
  const found = identityAt(reading, chosen);
  if (found === undefined || !sameBytes(found.bytes, bytes)) return undefined;
  const piecesOf = (from: number, to: number) =>
    reading.items.slice(Math.max(0, from), to).map((item) => reading.bytes.subarray(item.from, item.to));
  return {
    // A transport that was guessed from the bytes is no knowledge of its own.
    transport: transport === found.identities[0]?.transport ? undefined : transport,
    ...(found.request && { request: found.request }),
    preceding: piecesOf(chosen - PIECES, chosen),
    following: piecesOf(chosen + 1, chosen + 1 + PIECES),
  };
}
