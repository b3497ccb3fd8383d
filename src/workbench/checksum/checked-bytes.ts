import { decodeFrame, encodeFrame, FrameError, type Reading } from '../../modbus/index.ts';
import type { Evaluation } from '../frame/evaluate.ts';

/** The bytes of a frame that a checksum is taken over, and all that are sent. */
export interface CheckedBytes {
  /** Unit identifier and PDU, as far as the frame has them. */
  readonly body: Uint8Array;
  readonly whole: Uint8Array;
}

/** The current frame with and without what its transport puts around it; `undefined` if there is no frame. */
export function checkedBytes({ frame }: Evaluation): CheckedBytes | undefined {
  if (frame === undefined) return undefined;
  const { reading, bytes } = frame;
  const { transport, unitId, outcome, forced } = reading;
  if (transport === 'rtu') return { whole: bytes, body: withoutChecksum(reading, bytes) };
  if (transport === 'pdu' || unitId === undefined || outcome.kind !== 'whole') return { whole: bytes, body: bytes };
  // The checksum of an ASCII frame is over the bytes, not over the characters that carry them.
  const { checksum: _checksum, length: _length, protocolId: _protocolId, ...force } = forced;
  try {
    const rtu = encodeFrame({ ...reading, transport: 'rtu', force });
    const { direction } = reading;
    return { whole: bytes, body: withoutChecksum(decodeFrame(rtu, { transport: 'rtu', direction }), rtu) };
  } catch (error) {
    if (!(error instanceof FrameError)) throw error;
    return { whole: bytes, body: bytes };
  }
}

/** The bytes of an RTU frame without its CRC, if it has one. */
export function withoutChecksum({ spans }: Reading, bytes: Uint8Array): Uint8Array {
  const span = spans.find(({ kind }) => kind === 'checksum');
  return span ? bytes.filter((_, at) => at < span.from || at >= span.to) : bytes;
}
