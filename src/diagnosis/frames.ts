import { crc16, type Direction, decodeFrame, joinBytes, type Reading, type Transport } from '../modbus/index.ts';

export const DIRECTIONS: readonly Direction[] = ['request', 'response'];

export const join = (...parts: readonly ArrayLike<number>[]): Uint8Array => joinBytes(parts);

/** Unit identifier and PDU with their CRC behind them, low byte first (SL 2.5.1.2). */
export function withCrc(body: Uint8Array): Uint8Array {
  const value = crc16(body);
  return join(body, [value & 0xff, value >>> 8]);
}

/** Unit identifier and PDU behind an MBAP header (TG 3.1.3). */
export const withMbap = (body: Uint8Array, transactionId = 0): Uint8Array =>
  join([transactionId >>> 8, transactionId & 0xff, 0, 0, body.length >>> 8, body.length & 0xff], body);

/** Whether the bytes are one frame of this reading, its checksum included. */
export const isWhole = ({ outcome, forced }: Reading): boolean =>
  outcome.kind === 'whole' && forced['checksum'] === undefined;

export const hasErrors = ({ problems }: Reading): boolean => problems.some(({ severity }) => severity === 'error');

const PROOF: readonly Transport[] = ['rtu', 'tcp', 'ascii'];

/** Whether the bytes are a frame without an error, of one of these transports, in either direction. */
export const isSound = (frame: Uint8Array, transports: readonly Transport[] = PROOF): boolean =>
  transports.some((transport) =>
    DIRECTIONS.some((direction) => {
      const reading = decodeFrame(frame, { transport, direction });
      return reading.outcome.kind === 'whole' && !hasErrors(reading);
    }),
  );

/** A copy with other bytes at `at`. */
export function replaced(bytes: Uint8Array, at: number, ...others: readonly number[]): Uint8Array {
  const copy = bytes.slice();
  copy.set(others, at);
  return copy;
}

/** The sum of `bytes[from, to)`, in full: protocols keep the low byte of it, or two. */
export const sumOf = (bytes: Uint8Array, from: number, to: number): number =>
  bytes.subarray(from, to).reduce((total, byte) => total + byte, 0);

/** The two bytes of a number, high byte first. */
export const word = (bytes: Uint8Array, at: number): number => ((bytes[at] as number) << 8) | (bytes[at + 1] as number);

export const swapWord = (value: number): number => ((value & 0xff) << 8) | (value >>> 8);
