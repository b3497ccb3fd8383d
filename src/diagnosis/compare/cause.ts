import type { Direction, Transport } from '../../modbus/index.ts';

/** Whose value it is: `mine`, or that of the frame it is compared with. */
export type Whose = 'mine' | 'theirs';

/** Two values of one field. */
export interface Values {
  readonly mine: number;
  readonly theirs: number;
}
interface Check {
  /** As calculated from the bytes before it, and as found: the CRC's register, or the LRC. */
  readonly expected: number;
  readonly got: number;
  readonly algorithm: 'crc' | 'lrc';
}
interface Contradiction {
  readonly got: number;
  readonly expected: number;
}

/** What each cause of a difference says besides its field. The sentence is made elsewhere, from the code and this data. */
export interface CauseData {
  // Of the whole frame
  /** Every byte is the same. */
  identical: object;
  /** Theirs has another transport; `same` says that unit identifier and PDU are equal. */
  'other-transport': { readonly mine: Transport; readonly theirs: Transport; readonly same: boolean };
  /** Theirs is a reply and mine a request, or the reverse. */
  'other-direction': { readonly theirs: Direction };
  /** Theirs is the request that mine answers: an echo. */
  'echo-of-request': object;
  /** One side is an exception, and the other is not. */
  'exception-instead': {
    readonly whose: Whose;
    readonly functionCode: number;
    readonly exceptionCode: number | undefined;
  };
  /** Theirs carries the checksum of mine: its other bytes were changed after the checksum was made. */
  'changed-after-checksum': object;
  /** Bytes beyond what is compared were left out. */
  'left-out': Values;
  // Of the bytes, in any field
  'extra-before': { readonly bytes: number };
  'extra-after': { readonly bytes: number };
  /** Theirs ends too early by this many bytes. */
  truncated: { readonly missing: number };
  /** An ASCII frame without all of its CR LF. */
  'line-end-missing': object;
  'bytes-missing': { readonly bytes: number };
  'bytes-inserted': { readonly bytes: number };
  /** The bytes of each 16-bit number are the other way round. */
  'bytes-swapped': object;
  /** The 16-bit words of each 32-bit value are the other way round. */
  'words-swapped': object;
  /** All four bytes of each 32-bit value are the other way round. */
  'order-reversed': object;
  'bits-reversed': object;
  /** Both have the same digits, decimal on one side and hexadecimal on the other. */
  'decimal-as-hex': Values & { readonly hex: Whose };
  'lower-case-digits': object;
  'value-differs': Values;
  'content-differs': { readonly different: number; readonly of: number };
  'length-differs': Values;
  // Of the checksum
  /** Both hold; they differ because the bytes before them do. */
  'checksum-follows': object;
  'checksum-swapped': Check;
  /** The checksum alone is wrong: the bytes before it are the same. */
  'checksum-alone-wrong': Check;
  'checksum-wrong': Check;
  'my-checksum-wrong': Check;
  'checksum-missing': object;
  // Of single fields
  'unit-differs': Values;
  'other-table': Values;
  /** One writes a single item, the other several. */
  'single-or-multiple': Values;
  'function-differs': Values;
  /** The bytes belong to a field that the other function does not have. */
  'field-of-function': { readonly functionCode: number };
  'address-off-by-one': Values;
  /** One side has the number of the manual in place of the zero-based address, `base` above it. */
  'entity-number': { readonly whose: Whose; readonly number: number; readonly address: number };
  'address-differs': Values;
  /** One side counts bytes, or 16-bit halves of 32-bit values, and the other does not. */
  'quantity-doubled': Values & { readonly whose: Whose };
  /** One side counts the bytes that hold the bits. */
  'quantity-of-bytes': Values & { readonly whose: Whose };
  'quantity-differs': Values;
  'coil-value-illegal': { readonly got: number };
  'coil-opposite': { readonly theirs: number };
  'count-missing': object;
  'count-wrong': Contradiction;
  /** The byte count counts registers. */
  'count-of-registers': Contradiction;
  /** It differs because what it counts differs. */
  'count-follows': Values;
  'transaction-differs': Values;
  'protocol-differs': Values;
}

export type CauseCode = keyof CauseData;

/** Why two frames differ, as far as their bytes tell. */
export type Cause = { [C in CauseCode]: { readonly code: C } & CauseData[C] }[CauseCode];
