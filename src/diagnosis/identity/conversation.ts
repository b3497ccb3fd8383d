import {
  type Direction,
  decodeFrame,
  isAgainstRequest,
  isAsLongAsAsked,
  type Reading,
  type Severity,
  sameBytes,
  type Transport,
} from '../../modbus/index.ts';
import { CERTAIN } from '../evidence.ts';
import { otherProtocolOf } from '../other-protocols.ts';
import { type Identity, MOST_LOOKED_AT, rank, TRANSPORTS } from './identify.ts';
import { type ConversationChunk, type Piece, type PieceFrame, piecesOf } from './log-pieces.ts';
import { type OpenRequest, OpenRequests } from './open-requests.ts';

export type { ConversationChunk } from './log-pieces.ts';

/** One entry of a conversation, the bytes `[from, to)`: a whole or broken frame, or bytes that are not a frame. */
export type ConversationItem =
  | {
      readonly kind: 'frame';
      readonly from: number;
      readonly to: number;
      readonly transport: Transport;
      readonly direction: Direction;
      /** The index in the list of the request that it answers. */
      readonly answers: number | undefined;
      /** The severity of its worst problem, by itself and against its request. */
      readonly severity: Severity | undefined;
    }
  | { readonly kind: 'unread'; readonly from: number; readonly to: number };

/** The fewest bytes of a broken frame; fewer are stray bytes. */
const LEAST_BROKEN = 3;
/** The number of broken pieces that decides the transport if there is no whole frame. */
const SAMPLE = 32;

/**
 * The frames of a conversation that was read in chunks, such as the lines of a log, in order: each with its transport, its
 * direction, the request it answers, and the severity of its worst problem. The item of a frame with stray bytes around it
 * has all bytes of its chunk. The items cover all bytes of the chunks, which come in order; chunks that overlap one
 * before, or reach beyond the bytes, count without that part. Never throws; takes time linear in the number of bytes.
 * `onDone` hears how much is done, 0 to 1.
 */
export function readConversation(
  bytes: Uint8Array,
  chunks: readonly ConversationChunk[],
  onDone?: (done: number) => void,
): readonly ConversationItem[] {
  const pieces = piecesOf(bytes, chunks);
  const transports = transportsOf(bytes, pieces);
  const turned = areTurned(pieces);
  const requests = new OpenRequests(bytes);
  return pieces.map((piece, index) => {
    const { from, to, frame } = piece;
    onDone?.(index / pieces.length);
    const hint = turned ? OTHER[piece.hint ?? 'none'] : piece.hint;
    const told =
      frame === undefined ? tellBroken(bytes, piece, hint, transports, requests) : tell(bytes, frame, hint, requests);
    if (told === undefined) return { kind: 'unread', from, to };
    const { reading, answers } = told;
    const { transport, direction } = reading;
    if (direction === 'request') {
      const place = frame ?? { from, to: Math.min(to, from + MOST_LOOKED_AT) };
      requests.add({ transport, from: place.from, to: place.to, index, broken: frame === undefined });
    }
    if (answers !== undefined) requests.close(answers);
    // Stray bytes around a frame are not a problem of the frame itself.
    const severity = frame !== undefined && frame.to - frame.from < to - from ? 'error' : worst(reading);
    return { kind: 'frame', from, to, transport, direction, answers: answers?.index, severity };
  });
}

/** What a piece is, and the request that it answers. */
interface Told {
  readonly reading: Reading;
  readonly answers: OpenRequest | undefined;
}

/** Request or reply: as the text says, unless that is impossible, or else as the request before it suggests. */
function tell(bytes: Uint8Array, frame: PieceFrame, hint: Direction | undefined, requests: OpenRequests): Told {
  const { transport, from, to, directions } = frame;
  const reply = directions.includes('response') ? requests.replyOf(frame) : undefined;
  const fits =
    reply !== undefined &&
    (reply.answers.broken ? !isFinished(bytes, reply.answers, frame) : !isAgainstRequest(reply.reading));
  const guess: Direction = fits ? 'response' : 'request';
  const direction =
    [hint, guess].find((one) => one !== undefined && directions.includes(one)) ?? directions[0] ?? guess;
  if (direction === 'response' && reply !== undefined) return reply;
  return { reading: decodeFrame(bytes.subarray(from, to), { transport, direction }), answers: undefined };
}

/** Whether a frame is the broken one before it with its checksum: explanations show the bytes without it, and then with it. */
function isFinished(bytes: Uint8Array, broken: OpenRequest, { from, to, directions }: PieceFrame): boolean {
  const begun = bytes.subarray(broken.from, broken.to);
  const whole = bytes.subarray(from, to);
  return (
    directions.includes('request') && begun.length < whole.length && sameBytes(begun, whole.subarray(0, begun.length))
  );
}

/** What a piece that is not a whole frame most probably was; `undefined` if there is no evidence. */
function tellBroken(
  bytes: Uint8Array,
  { from, to, given }: Piece,
  hint: Direction | undefined,
  transports: readonly Transport[],
  requests: OpenRequests,
): Told | undefined {
  if (to - from < LEAST_BROKEN) return undefined;
  const start = bytes.subarray(from, Math.min(to, from + MOST_LOOKED_AT));
  if ((otherProtocolOf(start)?.bits ?? 0) >= CERTAIN) return undefined;
  const found: Identity[] = [];
  for (const transport of given === undefined ? transports : [given]) {
    const request = requests.bytesFor({ transport, from, to });
    for (const identity of rank(start, { request }, [transport]))
      if (identity.weight >= 0 || isAsLongAsAsked(identity.reading, to - from)) found.push(identity);
  }
  found.sort((a, b) => b.weight - a.weight);
  const reading = (found.find(({ direction }) => direction === hint) ?? found[0])?.reading;
  if (reading === undefined) return undefined;
  const { transport, direction } = reading;
  const answers = direction === 'response' ? requests.answeredBy(reading, { transport, from, to }) : undefined;
  return { reading, answers };
}

/** In which transports broken pieces are read: those of the whole frames, or else the one that fits the first best. */
function transportsOf(bytes: Uint8Array, pieces: readonly Piece[]): readonly Transport[] {
  const whole = new Set(pieces.flatMap(({ frame }) => (frame === undefined ? [] : [frame.transport])));
  if (whole.size > 0) return [...whole];
  const weights = new Map<Transport, number>(TRANSPORTS.map((transport) => [transport, 0]));
  for (const { from, to } of pieces.slice(0, SAMPLE)) {
    const [best] = rank(bytes.subarray(from, Math.min(to, from + MOST_LOOKED_AT)), {}, TRANSPORTS);
    if (best !== undefined) weights.set(best.transport, (weights.get(best.transport) ?? 0) + Math.max(0, best.weight));
  }
  return TRANSPORTS.toSorted((a, b) => (weights.get(b) ?? 0) - (weights.get(a) ?? 0)).slice(0, 1);
}

/** Whether the text has the directions the other way round, as in the log of a server, where requests are “Rx”. */
function areTurned(pieces: readonly Piece[]): boolean {
  let against = 0;
  for (const { hint, frame } of pieces) {
    if (hint === undefined || frame?.directions.length !== 1) continue;
    against += frame.directions[0] === hint ? -1 : 1;
  }
  return against > 0;
}

const OTHER = { request: 'response', response: 'request', none: undefined } as const;

const SEVERITIES: readonly Severity[] = ['error', 'warning', 'note'];

/** How bad the worst problem is. Logs leave out the line end of ASCII frames, so that this is not a problem. */
const worst = ({ checksum, problems }: Reading): Severity | undefined =>
  SEVERITIES.find((severity) =>
    problems.some(
      (problem) => problem.severity === severity && !(problem.code === 'frame-short' && checksum !== undefined),
    ),
  );
