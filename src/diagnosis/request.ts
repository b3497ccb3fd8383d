import { decodeFrame, encodeFrame, fromHex, type Reading, type Transport, toHex } from '../modbus/index.ts';
import { hasErrors, isWhole, join, withCrc, withMbap } from './frames.ts';

/** The request that the bytes answer. */
export interface Request {
  readonly bytes: Uint8Array;
  readonly reading: Reading;
  readonly unitId: number | undefined;
  readonly functionCode: number;
  /** Function code and data. */
  readonly pdu: Uint8Array;
}

const ORDER: readonly Transport[] = ['rtu', 'tcp', 'ascii', 'pdu'];
/**
 * Reads a request in the known transport, or else in the one in which it is a frame without an error. `undefined` if the
 * bytes have no function code.
 */
export function readRequest(bytes: Uint8Array, transport: Transport | undefined): Request | undefined {
  // The request may have been captured in another transport than its reply: if its form is clear, it decides.
  const order = transport ? [transport, ...ORDER.filter((other) => other !== transport)] : ORDER;
  const readings = order.map((one) => decodeFrame(bytes, { transport: one, direction: 'request' }));
  const reading = readings.find((one) => isWhole(one) && !hasErrors(one)) ?? readings[0];
  const pdu = reading && pduOf(reading, bytes);
  if (reading?.functionCode === undefined || pdu === undefined || pdu.length === 0) return undefined;
  return { bytes, reading, unitId: reading.unitId, functionCode: reading.functionCode, pdu };
}

/** Function code and data of a frame, between unit identifier and checksum; `undefined` if they cannot be read. */
export function pduOf({ spans, transport }: Reading, bytes: Uint8Array): Uint8Array | undefined {
  const from = spans.find(({ name }) => name === 'functionCode')?.from;
  if (from === undefined) return undefined;
  const behind = spans.find(({ name }) => name === 'checksum' || name === 'end' || name === 'after');
  const inside = bytes.subarray(from, behind?.from);
  return transport === 'ascii' ? fromHex(String.fromCharCode(...inside)) : inside;
}

/** Unit identifier, function code and data of a frame; unit 1 for a bare PDU. */
export function bodyOf(reading: Reading, bytes: Uint8Array): Uint8Array | undefined {
  const pdu = pduOf(reading, bytes);
  return pdu && join([reading.unitId ?? 1], pdu);
}

/** The frame of a unit identifier and a PDU in this transport. */
export function carriedBy(transport: Transport, body: Uint8Array, transactionId = 0): Uint8Array {
  switch (transport) {
    case 'rtu':
      return withCrc(body);
    case 'tcp':
      return withMbap(body, transactionId);
    case 'pdu':
      return body.slice(1);
    case 'ascii':
      return asciiOf(body);
  }
}

/** An ASCII frame of any unit identifier and PDU: the encoder's, with the PDU as raw data. */
function asciiOf(body: Uint8Array): Uint8Array {
  const [unitId, functionCode] = body;
  const rest = toHex(body, 2);
  // A code without a layout of its own carries its data as it is; the real one is forced over it.
  return encodeFrame({
    transport: 'ascii',
    direction: 'request',
    unitId,
    functionCode: RAW,
    fields: { data: rest },
    force: { functionCode: functionCode ?? 0 },
  });
}
const RAW = 0x41;

/** The request in the form that a reply in this transport answers; of the transaction of `reply` if it had none. */
export function requestAs(
  request: Request | undefined,
  transport: Transport,
  reply: Uint8Array,
): Uint8Array | undefined {
  if (request === undefined) return undefined;
  const { reading, bytes, pdu, unitId } = request;
  if (reading.transport === transport) return bytes;
  if (transport === 'pdu') return pdu;
  const transactionId = reply.length > 1 ? ((reply[0] as number) << 8) | (reply[1] as number) : 0;
  return carriedBy(transport, join([unitId ?? reply[transport === 'tcp' ? 6 : 0] ?? 1], pdu), transactionId);
}

/** Whether the reply to this request has the same bytes. */
export function isOwnReply({ bytes, reading: { transport } }: Request): boolean {
  const reading = decodeFrame(bytes, { transport, direction: 'response', request: bytes });
  return isWhole(reading) && !hasErrors(reading);
}
