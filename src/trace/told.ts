import {
  againstRequest,
  crc16,
  decodeFrame,
  isAgainstRequest,
  isAsLongAsAsked,
  MBAP,
  type Problem,
  type Reading,
  sameBytes,
} from '../modbus/index.ts';
import type { Carried, RecordSide } from './record.ts';

/** What a record is, found from its bytes, from what its source says, and from the request before it. */
export interface Told {
  readonly side: RecordSide;
  /** Read with the request, if it is a reply to one. */
  readonly reading: Reading;
  /** What makes it no frame that a receiver takes; `undefined` if a receiver takes it. */
  readonly flaw: Problem | undefined;
  /** It is read as a reply, and does not answer the request. */
  readonly strange: boolean;
  /** The very bytes of the request, which no reply to it can be. */
  readonly echo: boolean;
}

const COLON = 0x3a;
const LENGTH_AT = 4;

/** Whether the bytes are one ADU by their MBAP (TG 3.1.3): protocol 0, and the length that there is. */
export const isAdu = (bytes: Uint8Array): boolean =>
  bytes.length > MBAP &&
  bytes[2] === 0 &&
  bytes[3] === 0 &&
  (((bytes[LENGTH_AT] as number) << 8) | (bytes[LENGTH_AT + 1] as number)) === bytes.length - LENGTH_AT - 2;

/** How bytes are carried: as they show, or as the record before was, or as RTU. */
export function carriedAs(bytes: Uint8Array, before: Carried | undefined): Carried {
  if (bytes[0] === COLON) return 'ascii';
  const rtu = crc16(bytes) === 0;
  const tcp = isAdu(bytes);
  if (rtu !== tcp) return rtu ? 'rtu' : 'tcp';
  // A short RTU frame may look like an ADU (`01 03 00 00 00 02 …`), and an ADU hardly ever has a CRC that holds.
  return before === 'tcp' ? 'tcp' : 'rtu';
}

/** What is wrong with a frame by itself. Logs leave out the line end of ASCII frames, so that this is not a flaw. */
const flawIn = ({ checksum, problems }: Reading): Problem | undefined =>
  problems.find(
    ({ code, severity }) =>
      severity === 'error' && !againstRequest.has(code) && !(code === 'frame-short' && checksum !== undefined),
  );

/** What kind of fault a flaw is: a frame as long as it should be, whose CRC does not hold, was damaged, even if in its count. */
export const flawKind = (flaw: Problem, reading: Reading, bytes: Uint8Array): 'checksum' | 'broken' =>
  flaw.code === 'checksum-wrong' || isAsLongAsAsked(reading, bytes.length) ? 'checksum' : 'broken';

/**
 * What a record is. `said` is the side by its source, which the bytes may contradict only if they cannot be a frame of it;
 * `request` is the one that waits for a reply on the same line, and `fresh` says that the time-out has not passed since.
 */
export function tell(
  bytes: Uint8Array,
  transport: Carried,
  said: RecordSide | undefined,
  request: Uint8Array | undefined,
  fresh: boolean,
): Told {
  if (said !== 'request') {
    const reading = decodeFrame(bytes, { transport, direction: 'response', request });
    const strange = request !== undefined && isAgainstRequest(reading);
    const flaw = flawIn(reading);
    const reply = { side: 'response', reading, flaw, strange, echo: false } as const;
    if (
      said === 'response' &&
      transport !== 'tcp' &&
      request !== undefined &&
      (flaw !== undefined || strange) &&
      sameBytes(bytes, request)
    ) {
      return { ...reply, flaw: undefined, strange: false, echo: true };
    }
    if (said === 'response' || (request !== undefined && fresh && flaw === undefined && !strange)) return reply;
    const other = decodeFrame(bytes, { transport, direction: 'request' });
    const asked = flawIn(other);
    if (asked === undefined || (flaw !== undefined && request === undefined)) {
      return { side: 'request', reading: other, flaw: asked, strange: false, echo: false };
    }
    return reply;
  }
  const reading = decodeFrame(bytes, { transport, direction: 'request' });
  return { side: 'request', reading, flaw: flawIn(reading), strange: false, echo: false };
}
