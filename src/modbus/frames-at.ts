import { MOST_ASCII } from './ascii.ts';
import { decodeFrame } from './decode-frame.ts';
import { hexDigit } from './hex.ts';
import { readPdu } from './pdu.ts';
import { ALWAYS_OPEN, PduEnd } from './pdu-end.ts';
import { type Direction, Reading, type Transport } from './reading.ts';
import { MOST_RTU } from './rtu.ts';
import { CRC } from './serial.ts';
import { MBAP } from './tcp.ts';

/** A frame that bytes hold, proved by its checksum, or on TCP by its MBAP, and by its fields ending just where it does. */
export interface FrameAt {
  readonly transport: Exclude<Transport, 'pdu'>;
  readonly direction: Direction;
  readonly from: number;
  readonly to: number;
  /** No field breaks a rule of its own, and none is left with bytes that make no whole item. */
  readonly legal: boolean;
  /** Something in it is reserved or against the specification's advice. */
  readonly warned: boolean;
  /** No byte tells where the PDU ends: the frame was taken to end with the bytes, or where such frames usually do. */
  readonly open: boolean;
}

const DIRECTIONS: readonly Direction[] = ['request', 'response'];
const NONE: readonly FrameAt[] = Object.freeze([]);
const COLON = 0x3a;
const CR = 0x0d;
const LF = 0x0a;

const walk = new PduEnd();

/**
 * Every frame that may begin at `at` and ends at or before `end`: of each transport, or of one, in each direction, the
 * request first. A function whose length no byte tells is a candidate to `end` itself, and to the length it usually has.
 * Two candidates may end at different places: a reply that ends in 00 is a request too where the 00 before it closes one.
 * Never throws, and looks at no more bytes than the longest frame has, so that asking at every place is linear.
 */
export function framesAt(
  bytes: Uint8Array,
  at: number,
  end = bytes.length,
  transport?: FrameAt['transport'],
): readonly FrameAt[] {
  const found: FrameAt[] = [];
  if (transport !== 'rtu' && transport !== 'tcp' && bytes[at] === COLON) addAscii(found, bytes, at, end);
  if (transport !== 'ascii' && transport !== 'tcp') addRtu(found, bytes, at, end);
  if (transport !== 'ascii' && transport !== 'rtu') addTcp(found, bytes, at, end);
  return found.length === 0 ? NONE : found;
}

/** Unit identifier, function code and CRC. */
const LEAST_RTU = 4;

function addRtu(found: FrameAt[], bytes: Uint8Array, at: number, end: number): void {
  if (at + LEAST_RTU > end) return;
  const near = end <= at + MOST_RTU;
  if (!near && ALWAYS_OPEN[bytes[at + 1] as number]) return;
  const last = (near ? end : at + MOST_RTU) - CRC.width;
  let checked = 0;
  let holds = false;
  for (let i = 0; i < DIRECTIONS.length; i++) {
    const direction = DIRECTIONS[i] as Direction;
    const pdu = walk.of(direction, bytes, at + 1, last);
    const { open, usual } = walk;
    if (usual > 0 && usual < pdu && crcHolds(bytes, at, usual)) found.push(rtu(bytes, direction, at, usual));
    if (pdu > last || (open && !near)) continue;
    if (pdu !== checked) {
      checked = pdu;
      holds = crcHolds(bytes, at, pdu);
    }
    if (holds) found.push(rtu(bytes, direction, at, pdu));
  }
}

const crcHolds = (bytes: Uint8Array, at: number, pdu: number) => CRC.compute(bytes, at, pdu) === CRC.read(bytes, pdu);

function rtu(bytes: Uint8Array, direction: Direction, at: number, pdu: number): FrameAt {
  const reading = new Reading('rtu', direction, undefined);
  readPdu(reading, bytes, at + 1, pdu);
  return frame(reading, at, pdu + CRC.width, isLegal(reading, pdu));
}

function addTcp(found: FrameAt[], bytes: Uint8Array, at: number, end: number): void {
  if (at + MBAP >= end || bytes[at + 2] !== 0 || bytes[at + 3] !== 0 || bytes[at + 4] !== 0) return;
  const to = at + 6 + (bytes[at + 5] as number);
  if (to > end || to <= at + MBAP) return;
  for (const direction of DIRECTIONS) {
    if (walk.of(direction, bytes, at + MBAP, to) !== to) continue;
    const reading = new Reading('tcp', direction, undefined);
    readPdu(reading, bytes, at + MBAP, to);
    found.push(frame(reading, at, to, isLegal(reading, to)));
  }
}

function addAscii(found: FrameAt[], bytes: Uint8Array, at: number, end: number): void {
  const last = Math.min(end, at + MOST_ASCII);
  let digits = at + 1;
  while (digits < last && hexDigit(bytes[digits] as number) >= 0) digits++;
  // CR and the delimiter, which function 08 can change, or a lone LF.
  const to = digits + (bytes[digits] === CR ? 2 : 1);
  if (to > last || (bytes[digits] !== CR && bytes[digits] !== LF)) return;
  for (const direction of DIRECTIONS) {
    const reading = decodeFrame(bytes.subarray(at, to), { transport: 'ascii', direction });
    if (reading.outcome.kind !== 'whole' || reading.forced['checksum'] !== undefined) continue;
    // Closed by its end, a frame is whole whatever its fields say; here they have to agree.
    if (reading.problems.some(({ code }) => code === 'pdu-short' || code === 'pdu-rest')) continue;
    found.push(frame(reading, at, to, !reading.problems.some(isError)));
  }
}

const isError = ({ severity }: Reading['problems'][number]) => severity === 'error';

/** Whether a PDU whose fields end at `pdu` breaks no rule. */
const isLegal = ({ problems, spans }: Reading, pdu: number): boolean =>
  spans[spans.length - 1]?.to === pdu && !problems.some(isError);

const frame = (
  { transport, direction, open, problems }: Reading,
  from: number,
  to: number,
  legal: boolean,
): FrameAt => ({
  transport: transport as FrameAt['transport'],
  direction,
  from,
  to,
  legal,
  warned: problems.some(({ severity }) => severity === 'warning'),
  open,
});
