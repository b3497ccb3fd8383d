import {
  type DecodeContext,
  type Direction,
  framesAt,
  type Reading,
  sameBytes,
  type Transport,
} from '../../modbus/index.ts';
import { readSide, type Side } from './side.ts';

const TRANSPORTS: readonly Transport[] = ['rtu', 'ascii', 'tcp'];
const DIRECTIONS: readonly Direction[] = ['request', 'response'];
const COLON = 0x3a;
const CR_LF = [0x0d, 0x0a];

/**
 * Reads the bytes to compare with: as mine is read, unless they are plainly of the other direction or of
 * another transport. A checksum or an MBAP that holds outweighs the same function, this the same transport, and this the
 * same direction.
 */
export function readTheirs(mine: Side, bytes: Uint8Array, context: DecodeContext): Side {
  const pdu = pduOf(mine);
  if (context.transport !== 'pdu' && pdu.length > 0 && sameBytes(pdu, bytes)) {
    return readSide(bytes, { ...context, transport: 'pdu' });
  }
  let best = readSide(bytes, context);
  let most = -1;
  for (const direction of DIRECTIONS) {
    for (const transport of transportsFor(context.transport)) {
      const side = readSide(bytes, { transport, direction, request: context.request });
      const sameFunction = functionOf(side) === functionOf(mine);
      const fit = fitOf(side);
      const home = transport === context.transport;
      if (!home && !(fit === PROVED && sameFunction)) continue;
      // The beginning of a request may look like a short reply, and a damaged function code like any other.
      const other = direction !== context.direction && fit !== PROVED;
      if (other && (!sameFunction || isCut(mine.bytes, bytes) || isCut(bytes, mine.bytes))) continue;
      const score = 8 * fit + (sameFunction ? 4 : 0) + (home ? 2 : 0) + (direction === context.direction ? 1 : 0);
      if (score > most) {
        most = score;
        best = side;
      }
    }
  }
  return best;
}

const transportsFor = (home: Transport): readonly Transport[] => (home === 'pdu' ? ['pdu', ...TRANSPORTS] : TRANSPORTS);

export const PROVED = 2;
export const FITS = 1;

/** Whether the frame's checksum or MBAP holds, or at least its fields end where it does. */
export function fitOf({ bytes, start, end, reading }: Side): number {
  const { transport, direction } = reading;
  if (transport === 'pdu') return fieldsFit(reading) ? FITS : 0;
  const frame = bytes.subarray(start, end);
  const line = transport === 'ascii' ? withEnd(frame) : frame;
  const proved = framesAt(line, 0).some(
    (found) => found.transport === transport && found.direction === direction && found.to === line.length,
  );
  return proved ? PROVED : fieldsFit(reading) ? FITS : 0;
}

/** A line is often copied without its CR LF. */
function withEnd(bytes: Uint8Array): Uint8Array {
  if (bytes[0] !== COLON || bytes[bytes.length - 1] === CR_LF[1]) return bytes;
  const bare = bytes[bytes.length - 1] === CR_LF[0] ? bytes.subarray(0, -1) : bytes;
  return Uint8Array.of(...bare, ...CR_LF);
}

const MISFITS = new Set(['pdu-rest', 'pdu-short', 'count-wrong', 'mbap-length-wrong']);

const fieldsFit = ({ outcome, problems }: Reading) =>
  outcome.kind === 'whole' && !problems.some(({ code }) => MISFITS.has(code));

/** The function code without the exception bit of a reply. */
export const functionOf = ({ reading: { functionCode, direction } }: Side): number | undefined =>
  functionCode !== undefined && direction === 'response' ? functionCode & 0x7f : functionCode;

/** Function code and data. */
function pduOf({ bytes, spans, start, reading }: Side): Uint8Array {
  const from = spans.find(({ kind }) => kind === 'function')?.from;
  const end = spans.find(({ kind, from: at }) => kind === 'checksum' && at >= start)?.from;
  return from === undefined || reading.transport === 'ascii' ? new Uint8Array() : bytes.subarray(from, end);
}

/** Whether `whole` begins with `part`. */
export const isCut = (whole: Uint8Array, part: Uint8Array): boolean => sameBytes(whole.subarray(0, part.length), part);
