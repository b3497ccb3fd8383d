import { encodeFrame, FrameError } from '../../modbus/index.ts';
import type { Evaluation } from '../../workbench/index.ts';

/** The bytes of the frame at hand that a checksum is taken over, and all that are sent. */
export interface AtHand {
  /** Unit identifier and PDU, or what there is of them. */
  readonly body: Uint8Array;
  readonly whole: Uint8Array;
}

const CRC_SIZE = 2;

/** The frame at hand with and without what its transport puts around it; `undefined` where there is none. */
export function atHand({ frame }: Evaluation): AtHand | undefined {
  if (frame === undefined) return undefined;
  const { reading, bytes } = frame;
  const { transport, unitId, outcome, spans, forced } = reading;
  const span = transport === 'rtu' ? spans.find(({ kind }) => kind === 'checksum') : undefined;
  if (span) return { whole: bytes, body: bytes.filter((_, at) => at < span.from || at >= span.to) };
  if (transport === 'pdu' || transport === 'rtu' || unitId === undefined || outcome.kind !== 'whole') {
    return { whole: bytes, body: bytes };
  }
  // The checksum of an ASCII frame is over the bytes, not over the characters that carry them.
  const { checksum: _checksum, length: _length, protocolId: _protocolId, ...force } = forced;
  try {
    const rtu = encodeFrame({ ...reading, transport: 'rtu', force });
    return { whole: bytes, body: rtu.subarray(0, rtu.length - CRC_SIZE) };
  } catch (error) {
    if (!(error instanceof FrameError)) throw error;
    return { whole: bytes, body: bytes };
  }
}
