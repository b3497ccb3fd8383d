import { crc16, fromHex, lrc, type Reading } from '../../modbus/index.ts';

/** The register after a byte of the frame has been taken in. */
export interface RegisterAfter {
  /** The place of the byte in the frame, from 0. */
  readonly at: number;
  readonly value: number;
  readonly register: number;
}

/** How the checksum of a frame comes about. */
export type FrameChecksum =
  | { readonly kind: 'none'; readonly why: 'tcp' | 'pdu' | 'not-digits' }
  | {
      readonly kind: 'crc';
      /** The bytes that it covers, which begin the frame. */
      readonly covered: Uint8Array;
      readonly initial: number;
      /** The last of the registers, in the order of the bytes. */
      readonly last: readonly RegisterAfter[];
      readonly register: number;
      /** As it is sent, the low byte first (SL 2.5.1.2). */
      readonly sent: Uint8Array;
      /** What the frame has in its place; `undefined` if the frame ends before it. */
      readonly got: Uint8Array | undefined;
    }
  | {
      readonly kind: 'lrc';
      /** The bytes that it covers, not the characters that carry them. */
      readonly covered: Uint8Array;
      readonly sum: number;
      /** The two's complement of the sum's low byte (SL 2.5.2.2). */
      readonly lrc: number;
      /** The characters that the frame has in its place; `undefined` if the frame ends before them. */
      readonly got: Uint8Array | undefined;
    };

/** Bytes whose registers are told: enough to see how the last ones change them. */
const TOLD = 8;

/** How the checksum of a frame comes about, or why it has none. */
export function frameChecksum(reading: Reading, bytes: Uint8Array): FrameChecksum {
  const { transport, spans } = reading;
  if (transport === 'tcp' || transport === 'pdu') return { kind: 'none', why: transport };
  const place = spans.find(({ kind }) => kind === 'checksum');
  const got = place && bytes.slice(place.from, place.to);
  const end = place?.from ?? spans.find(({ name }) => name === 'end')?.from ?? bytes.length;
  if (transport === 'rtu') return crcOf(bytes.slice(0, end), got);
  const begin = spans.find(({ name }) => name === 'start')?.to ?? 0;
  const covered = fromHex(String.fromCharCode(...bytes.subarray(begin, end)));
  if (covered === undefined) return { kind: 'none', why: 'not-digits' };
  return { kind: 'lrc', covered, sum: covered.reduce((sum, byte) => sum + byte, 0), lrc: lrc(covered), got };
}

/** What the register begins with (SL 2.5.1.2). */
const INITIAL = 0xffff;

function crcOf(covered: Uint8Array, got: Uint8Array | undefined): FrameChecksum {
  const registers: RegisterAfter[] = [];
  let register = INITIAL;
  covered.forEach((value, at) => {
    register = crc16(covered, at, at + 1, register);
    registers.push({ at, value, register });
  });
  return {
    kind: 'crc',
    covered,
    initial: INITIAL,
    last: registers.slice(-TOLD),
    register,
    sent: Uint8Array.of(register & 0xff, register >>> 8),
    got,
  };
}
