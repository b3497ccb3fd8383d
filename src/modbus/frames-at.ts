import { decodeFrame } from './decode-frame.ts';
import { readPdu } from './pdu.ts';
import { type Direction, Reading, type Transport } from './reading.ts';
import { CRC } from './serial.ts';
import { MBAP } from './tcp.ts';

/** A frame that bytes hold, proved by its checksum, or on TCP by its MBAP, and by its fields ending just where it does. */
export interface FrameAt {
  readonly transport: Exclude<Transport, 'pdu'>;
  readonly direction: Direction;
  readonly from: number;
  readonly to: number;
  /** No field breaks a rule of its own. */
  readonly legal: boolean;
  /** No byte tells where the PDU ends: the frame was taken to end with the bytes. */
  readonly open: boolean;
}

const DIRECTIONS: readonly Direction[] = ['request', 'response'];
const COLON = 0x3a;
const LF = 0x0a;

/**
 * Every frame that may begin at `at` and ends at or before `end`: of each transport, in each direction. A function whose
 * length no byte tells is a candidate only to `end` itself. Never throws.
 */
export function framesAt(bytes: Uint8Array, at: number, end = bytes.length): readonly FrameAt[] {
  const ascii = bytes[at] === COLON ? asciiAt(bytes, at, end) : [];
  return [...ascii, ...rtuAt(bytes, at, end), ...tcpAt(bytes, at, end)];
}

function rtuAt(bytes: Uint8Array, at: number, end: number): FrameAt[] {
  const found: FrameAt[] = [];
  for (const direction of DIRECTIONS) {
    const reading = new Reading('rtu', direction, undefined);
    const pdu = readPdu(reading, bytes, at + 1, end - CRC.width);
    if (pdu + CRC.width > end || CRC.compute(bytes, at, pdu) !== CRC.read(bytes, pdu)) continue;
    found.push(frame(reading, at, pdu + CRC.width));
  }
  return found;
}

function tcpAt(bytes: Uint8Array, at: number, end: number): FrameAt[] {
  if (at + MBAP >= end || bytes[at + 2] !== 0 || bytes[at + 3] !== 0 || bytes[at + 4] !== 0) return [];
  const to = at + 6 + (bytes[at + 5] as number);
  if (to > end) return [];
  const found: FrameAt[] = [];
  for (const direction of DIRECTIONS) {
    const reading = new Reading('tcp', direction, undefined);
    if (readPdu(reading, bytes, at + MBAP, to) === to) found.push(frame(reading, at, to));
  }
  return found;
}

function asciiAt(bytes: Uint8Array, at: number, end: number): FrameAt[] {
  const line = bytes.indexOf(LF, at);
  const to = line < 0 || line >= end ? end : line + 1;
  const found: FrameAt[] = [];
  for (const direction of DIRECTIONS) {
    const reading = decodeFrame(bytes.subarray(at, to), { transport: 'ascii', direction });
    if (reading.outcome.kind === 'whole' && reading.forced['checksum'] === undefined) {
      found.push(frame(reading, at, to));
    }
  }
  return found;
}

const frame = ({ transport, direction, problems, open }: Reading, from: number, to: number): FrameAt => ({
  transport: transport as FrameAt['transport'],
  direction,
  from,
  to,
  legal: !problems.some(({ severity }) => severity === 'error'),
  open,
});
