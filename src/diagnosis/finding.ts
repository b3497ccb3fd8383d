import type { Direction, Problem, ProblemData, Transport } from '../modbus/index.ts';
import type { MisprintedFrame, MisprintedFrameId } from './misprinted-frames.ts';
import type { Recognized } from './other-protocols.ts';

/** A checksum that stands in the bytes, and the one that belongs there; a CRC as its register's value. */
export interface Checked {
  readonly got: number;
  readonly expected: number;
}
/** A value against that of the request. */
export interface Mismatch {
  readonly got: number;
  readonly expected: number;
}
interface Missing {
  /** Bytes (in ASCII, characters) that are missing. */
  readonly missing: number;
}

/** What each finding says besides its place and its repair. Sentences are made elsewhere, from the code and this data. */
export interface FindingData {
  // Nothing is wrong
  /** A whole frame. It has both directions if a request and a reply of these bytes look the same. */
  readonly valid: {
    readonly transport: Transport;
    readonly directions: readonly Direction[];
    readonly functionCode: number;
    /** The checksum holds, but the bytes are fewer than the function's fields. */
    readonly fields: 'fit' | 'too-few';
  };
  /** A whole exception reply to `functionCode`, the code without the exception bit. */
  readonly 'valid-exception': {
    readonly transport: Transport;
    readonly functionCode: number;
    readonly exceptionCode: number;
  };
  /** Not a frame, but its bytes make plausible registers. */
  readonly 'valid-data': { readonly registers: number; readonly plausible: 'float' | 'integer' };

  // Checksum
  readonly 'crc-byte-order': Checked;
  /** The CRC is that of the bytes written down as `text`. */
  readonly 'crc-of-text': Checked & { readonly text: string; readonly swapped: boolean };
  readonly 'crc-algorithm': Checked & { readonly algorithm: string; readonly swapped: boolean };
  readonly 'crc-start-value': Checked & { readonly start: number };
  /** The CRC was calculated over bytes other than those from the unit identifier to the last data byte. */
  readonly 'crc-span': Checked & {
    /** `part`: bytes `[first, last)` only. `length`: with the number of bytes in front. */
    readonly over: 'part' | 'with-checksum' | 'with-length' | 'with-mbap';
    readonly first: number;
    readonly last: number;
  };
  /** `shorter` and `longer`: the same frame with fewer items in its list, or with zeros behind them. */
  readonly 'crc-of-other-frame': Checked & {
    readonly of: 'request' | 'reply' | 'exception' | 'shorter' | 'longer';
  };
  readonly 'crc-is-something-else': Checked & {
    readonly as: 'exception' | 'line-end' | 'ones' | 'length' | 'last-data' | 'lrc';
  };
  readonly 'crc-missing': { readonly zero: boolean; readonly expected: number };
  readonly 'lrc-instead-of-crc': { readonly got: number; readonly expected: number };
  readonly 'crc-instead-of-lrc': { readonly got: number; readonly expected: number };
  /** One bit of byte `at` is wrong; with `expected` there the CRC holds. */
  readonly 'bit-error': { readonly at: number; readonly bit: number; readonly got: number; readonly expected: number };
  /** As `bit-error`, but more than one bit is wrong; changing one of `others` other bytes would do as well. */
  readonly 'byte-error': {
    readonly at: number;
    readonly got: number;
    readonly expected: number;
    readonly others: number;
  };
  /** A byte in the middle is one too many, or was lost. */
  readonly 'byte-inserted': { readonly at: number; readonly got: number };
  readonly 'byte-lost': { readonly at: number; readonly lost: number };
  /**
   * A frame as a known source misprints it: its CRC, or the low byte of its address. `swapped` says that the bytes of the
   * misprinted CRC are exchanged as well.
   */
  readonly 'known-misprint': Checked & {
    readonly misprint: MisprintedFrameId;
    readonly wrong: MisprintedFrame['wrong'];
    readonly swapped: boolean;
  };
  /** No known cause explains the checksum. */
  readonly 'crc-wrong': Checked;
  readonly 'lrc-wrong': Checked;
  readonly 'lrc-missing': { readonly expected: number };

  // Shape
  /** The request itself. `rest` bytes follow it; `wrong` of its bytes are not as they were sent. */
  readonly echo: { readonly wrong: number; readonly rest: number };
  readonly 'truncated-echo': Missing & { readonly wrong: number };
  /** `previous`: the bytes in front are the end of the frame before. */
  readonly 'stray-leading': { readonly leading: number; readonly previous: boolean };
  readonly 'stray-trailing': { readonly trailing: number; readonly zero: boolean };
  readonly 'stray-around': { readonly leading: number; readonly trailing: number };
  readonly 'stray-leading+truncated': Missing & { readonly leading: number };
  readonly truncated: Missing & { readonly has: number };
  /** `lines` pieces make up one frame. */
  readonly fragments: { readonly lines: number };
  readonly merged: { readonly frames: number; readonly between: number };
  /** The first `by` bytes belong at the end. */
  readonly rotated: { readonly by: number };
  /** `got` is `undefined` if the byte count itself is missing. */
  readonly 'byte-count': { readonly got: number | undefined; readonly expected: number };
  readonly 'extra-bytes': { readonly bytes: number };
  /**
   * Not a frame. `pattern` says what the bits look like: sampled `times` as often as they were sent (half and three quarters are
   * `too-slow`); all bytes of one parity; ones and zeros exchanged; the bits of each byte reversed; a line that does not change; or
   * no known pattern.
   */
  readonly noise: {
    readonly pattern: 'too-fast' | 'too-slow' | 'parity' | 'polarity' | 'bit-order' | 'constant' | 'unknown';
    readonly times: number | undefined;
  };
  /** Not a Modbus frame, but a message of another protocol. */
  readonly 'other-protocol': Pick<Recognized, 'protocol' | 'proof'>;
  /**
   * An RTU frame in the envelope of another protocol; it has the bytes `[from, to)`. `serial` is the number of the logger, `holds`
   * says whether the sum of the envelope does.
   */
  readonly envelope: { readonly protocol: 'solarman-v5'; readonly serial: number; readonly holds: boolean };
  readonly 'ascii-line-end': { readonly got: string };
  /** The bytes are the characters of hexadecimal text. */
  readonly 'hex-of-ascii-frame': { readonly text: string; readonly inMbap: boolean };

  // Meaning
  readonly 'unit-mismatch': Mismatch;
  readonly 'function-mismatch': Mismatch;
  readonly 'exception-of-other-function': Mismatch & { readonly exceptionCode: number };
  readonly 'broadcast-answered': ProblemData['broadcast-answered'];
  readonly 'coil-value-illegal': ProblemData['coil-value-illegal'];
  readonly 'padding-bits': { readonly quantity: number; readonly got: number };
  /** Byte counts of the reply, got and asked for. */
  readonly 'quantity-mismatch': Mismatch;
  /** One side counts 32-bit values, the other 16-bit registers. Byte counts, got and asked for. */
  readonly 'quantity-in-32-bit': Mismatch;
  /** The first value, as it stands and with its bytes exchanged. */
  readonly 'register-bytes-swapped': { readonly got: number; readonly swapped: number };
  /** The address is `number`, as manuals number that table's elements, where `address` should have been sent. */
  readonly 'address-is-number': { readonly number: number; readonly address: number };
  readonly 'address-off-by-one': Mismatch;
  /** Function `functionCode` reads another table than the number that was sent belongs to. */
  readonly 'function-of-other-table': {
    readonly functionCode: number;
    readonly meant: number;
    readonly number: number | undefined;
  };
  readonly 'mbap-on-serial': { readonly transactionId: number };
  readonly 'rtu-on-tcp': object;
  readonly 'rtu-on-ascii': object;
  readonly 'crc-on-tcp': object;
  readonly 'mbap-length': { readonly got: number; readonly expected: number; readonly swapped: boolean };
  readonly 'transaction-swapped': Mismatch;
  readonly 'transaction-mismatch': Mismatch;
  /** A rule of the specification is broken, and no other finding covers it. */
  readonly 'rule-broken': { readonly problem: Problem };
}

export type FindingCode = keyof FindingData;

/**
 * How sure it is. *certain*: chance would do this less than once in a million times; *likely*: less than once in
 * ten thousand; *possible*: it fits, and so may other things.
 */
export type Confidence = 'certain' | 'likely' | 'possible';

interface Place {
  /** The bytes it rests on, `[from, to)`. */
  readonly from: number;
  readonly to: number;
  /** Whole frames that were probably meant, the most probable first; all of them are valid. Empty if there is no repair. */
  readonly repaired: readonly Uint8Array[];
}

/** Why a frame fails, or that nothing is wrong with it. */
export type Finding = {
  [C in FindingCode]: { readonly code: C; readonly confidence: Confidence } & Place & FindingData[C];
}[FindingCode];

/**
 * A finding that a hypothesis offers, with the evidence for it in bits: by how much better than chance it explains all of
 * the bytes (log2 of the odds), less what it had to assume and less the number of things tried.
 */
export type Offer = {
  [C in FindingCode]: {
    readonly code: C;
    readonly bits: number;
    /** However much it explains, its confidence is `possible`. */
    readonly guess?: boolean;
  } & Place &
    FindingData[C];
}[FindingCode];
