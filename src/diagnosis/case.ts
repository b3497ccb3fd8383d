import { crc16, type Direction, decodeFrame, MOST_ASCII, type Reading, type Transport } from '../modbus/index.ts';
import { CRC_BITS, endsThere, LRC_BITS, likeness } from './evidence.ts';
import { DIRECTIONS, isWhole } from './frames.ts';
import { type Request, readRequest, requestAs } from './request.ts';

/** What is known besides the bytes. */
export interface DiagnoseContext {
  /** The transport that was used; without it every transport is considered. */
  readonly transport?: Transport | undefined;
  /** The request, as it was sent, that these bytes answer. */
  readonly request?: Uint8Array | undefined;
  /** The pieces received just before and just after, in order, if the bytes came in pieces. */
  readonly preceding?: readonly Uint8Array[] | undefined;
  readonly following?: readonly Uint8Array[] | undefined;
}

/** Unit identifier and PDU of a serial frame, as far as its fields reach. */
export interface Body {
  readonly direction: Direction;
  readonly unitId: number;
  /** The reading of the PDU alone. */
  readonly reading: Reading;
  readonly from: number;
  /** Where the PDU ends by its fields; beyond the end of the bytes if some of it is missing. */
  readonly end: number;
  /** How well it fits, see `likeness`. */
  readonly bits: number;
}

/** A whole frame with the right checksum, or on TCP the right header. */
export interface WholeFrame {
  readonly reading: Reading;
  /** The evidence that the bytes are this frame. */
  readonly bits: number;
}

/** The bytes in question, and what all hypotheses need to know of them. */
export interface Case {
  readonly bytes: Uint8Array;
  /** There were more bytes than are examined. */
  readonly cut: boolean;
  readonly transport: Transport | undefined;
  readonly request: Request | undefined;
  readonly preceding: readonly Uint8Array[];
  readonly following: readonly Uint8Array[];
  /** The readings as a serial frame that begins with the first byte; only replies if the request is known. */
  readonly bodies: readonly Body[];
  readonly wholes: readonly WholeFrame[];
}

/** The bytes that are examined: sixteen of the longest frames. */
const MOST_BYTES = 4096;
/** One more than the longest frame of any transport, so that a piece that is cut here is not a frame. */
const LONGEST = MOST_ASCII + 1;
/** Pieces that are considered before and after. */
const MOST_PIECES = 16;
const CARRIED: readonly Transport[] = ['rtu', 'tcp', 'ascii'];
const TRANSPORTS: readonly Transport[] = [...CARRIED, 'pdu'];

/** The first bytes, as a plain array: subclasses such as Node's Buffer copy differently. */
const plain = (bytes: Uint8Array, most: number) => new Uint8Array(bytes.subarray(0, most));

export function makeCase(all: Uint8Array, context: DiagnoseContext): Case {
  const bytes = plain(all, MOST_BYTES);
  const transport = TRANSPORTS.find((known) => known === context.transport);
  const request = context.request && readRequest(plain(context.request, LONGEST), transport);
  const serial = transport === undefined || transport === 'rtu';
  const directions = request ? (['response'] as const) : DIRECTIONS;
  return {
    bytes,
    cut: all.length > bytes.length,
    transport,
    request,
    preceding: context.preceding?.slice(-MOST_PIECES).map((piece) => plain(piece, LONGEST)) ?? [],
    following: context.following?.slice(0, MOST_PIECES).map((piece) => plain(piece, LONGEST)) ?? [],
    bodies: serial ? directions.map((direction) => bodyAt(bytes, 0, direction, request)) : [],
    wholes: (transport ? [transport] : CARRIED).flatMap((one) => wholesOf(bytes, one, request)),
  };
}

/** The serial body that begins at `from`. */
export function bodyAt(bytes: Uint8Array, from: number, direction: Direction, request: Request | undefined): Body {
  const pdu = bytes.subarray(from + 1);
  const asked = direction === 'response' ? request?.pdu : undefined;
  const reading = decodeFrame(pdu, { transport: 'pdu', direction, request: asked });
  const { outcome } = reading;
  const past = outcome.kind === 'short' ? outcome.missing : outcome.kind === 'extra' ? -outcome.bytes : 0;
  const unitId = bytes[from] ?? 0;
  return {
    direction,
    unitId,
    reading,
    from,
    end: bytes.length + past,
    bits: likeness(reading, unitId, asked && request),
  };
}

/** How unlikely it is, in bits, that bytes are a frame of each transport by chance. */
const PROOF: Readonly<Record<Transport, number>> = { rtu: CRC_BITS, tcp: 14, ascii: LRC_BITS + 10, pdu: -4 };
const IN_HEADER = new Set(['mbap-length-wrong', 'mbap-length-out-of-range', 'protocol-id-not-zero']);

/** The bytes as a whole frame of this transport, in each direction in which they are one. */
export function wholesOf(bytes: Uint8Array, transport: Transport, request: Request | undefined): WholeFrame[] {
  if (transport === 'rtu' && isFrameAndZeros(bytes)) return [];
  return DIRECTIONS.flatMap((direction) => {
    const known = direction === 'response' ? request : undefined;
    const reading = decodeFrame(bytes, { transport, direction, request: requestAs(known, transport, bytes) });
    if (!isWhole(reading) || reading.problems.some(({ code }) => IN_HEADER.has(code))) return [];
    const bits = likeness(reading, reading.unitId, known) + PROOF[transport] + endsThere(reading);
    return [{ reading, bits }];
  });
}

/** The most zeros behind a frame that a line adds by accident. */
const MOST_ZEROS = 4;

/**
 * Whether the bytes are a frame whose end its fields tell, followed by zeros. Zeros behind a CRC do not change whether it
 * holds, so it holds for all of the bytes too; that the zeros belong to the frame is far less likely.
 */
export function isFrameAndZeros(bytes: Uint8Array): boolean {
  for (let end = bytes.length - 1; end >= bytes.length - MOST_ZEROS && bytes[end] === 0; end--) {
    if (crc16(bytes, 0, end) !== 0) return false;
    const frame = bytes.subarray(0, end);
    const isFrame = ({ outcome, open, problems }: Reading) =>
      outcome.kind === 'whole' && !open && problems.every(({ severity }) => severity !== 'error');
    if (DIRECTIONS.some((direction) => isFrame(decodeFrame(frame, { transport: 'rtu', direction })))) return true;
  }
  return false;
}

/** A serial body with two bytes behind it that are not its CRC. */
export interface WrongCrc extends Body {
  readonly got: number;
  readonly expected: number;
}

/**
 * The bodies whose CRC is wrong: those that end two bytes before the end. A body without a fixed end is assumed to end
 * there.
 */
export function wrongCrcs({ bytes, bodies, cut }: Case): WrongCrc[] {
  const end = bytes.length - 2;
  if (cut || end < 2) return [];
  const got = (bytes[end] as number) | ((bytes[end + 1] as number) << 8);
  const expected = crc16(bytes, 0, end);
  if (got === expected) return [];
  return bodies
    .filter(({ reading, end: own }) => own === end || reading.open)
    .map((body) => ({ ...body, end, got, expected, bits: body.bits + endsThere(body.reading) }));
}

/** Whether a whole frame has nothing that is a finding of its own. */
export const isClean = ({ reading }: WholeFrame): boolean =>
  reading.problems.every(({ code, severity }) => severity !== 'error' && code !== 'padding-not-zero');
