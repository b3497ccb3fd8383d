import { crc } from '../crc.ts';
import type { CrcAlgorithm } from '../crc-catalogue.ts';
import { type ByteStep, CrcSteps } from './crc-steps.ts';

/** What a receiver finds if it includes the received CRC in its own. */
export interface ReceiverCheck {
  /** The CRC as it is sent. */
  readonly sent: Uint8Array;
  /** What each of these bytes does to the receiver's register. */
  readonly steps: readonly ByteStep[];
  /** The register at the end; it is the same for every message. */
  readonly residue: number;
  /** What would be left if the bytes of the CRC were sent in the opposite order. */
  readonly swapped: number;
}

/**
 * The bytes of a CRC in the order in which a receiver can feed them into its register: the lowest first if the register
 * moves to the right, else the highest (SL 2.5.1.2). `undefined` if the CRC does not have whole bytes, or if its value is
 * reflected against its register.
 */
export function sentBytes({ width, refin, refout }: CrcAlgorithm, value: number): Uint8Array | undefined {
  if (width % 8 !== 0 || refin !== refout) return undefined;
  const size = width / 8;
  return Uint8Array.from({ length: size }, (_, i) => value >>> (8 * (refin ? i : size - 1 - i)));
}

/** The receiver's check of a message followed by its CRC; `undefined` if `sentBytes` answers `undefined`. */
export function receiverCheck(algorithm: CrcAlgorithm, bytes: Uint8Array): ReceiverCheck | undefined {
  const sent = sentBytes(algorithm, crc(algorithm, bytes));
  if (!sent) return undefined;
  const received = new CrcSteps(algorithm, Uint8Array.of(...bytes, ...sent));
  const swapped = new CrcSteps(algorithm, Uint8Array.of(...bytes, ...sent.toReversed()));
  return {
    sent,
    steps: Array.from(sent, (_, i) => received.byte(bytes.length + i)),
    residue: received.unxored,
    swapped: swapped.unxored,
  };
}
