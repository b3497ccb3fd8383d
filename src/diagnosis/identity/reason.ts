/** What speaks for a reading of bytes, or against it. The sentence is made elsewhere, from the code and this data. */
export interface ReasonData {
  // The transport
  'checksum-holds': { readonly algorithm: 'crc' | 'lrc' };
  'checksum-wrong': { readonly algorithm: 'crc' | 'lrc' };
  /** Protocol identifier 0, and as many bytes as the length field says. */
  'mbap-fits': { readonly length: number };
  /** Protocol identifier 0, but another number of bytes behind the length field than it says. */
  'mbap-length-differs': { readonly got: number; readonly expected: number };
  'no-mbap': object;
  colon: object;
  'no-colon': object;
  /** Between colon and line end stand only hexadecimal digits, or also `others` other characters. */
  'hex-digits': object;
  'other-characters': { readonly others: number };
  /** The function code and its data alone: neither checksum nor MBAP; `fits` if they are exactly that, and legal. */
  'bare-pdu': { readonly fits: boolean };
  /** A whole frame stands in `bytes[from, to)`, with others around it; the reasons after this one are that frame's. */
  'frame-inside': { readonly from: number; readonly to: number };
  // The fields
  'known-function': { readonly functionCode: number };
  /** A public function that does not exist on TCP. */
  'function-serial-only': { readonly functionCode: number };
  'unknown-function': { readonly functionCode: number };
  /** The fields end where the frame does. */
  'fields-fit': object;
  /** The same, and a byte count says so; `registers` if the bytes it counts are registers. */
  'byte-count-fits': { readonly got: number; readonly registers: number | undefined };
  'fields-do-not-fit': object;
  'length-short': { readonly missing: number };
  'length-extra': { readonly bytes: number };
  /** Values that break `errors` rules. */
  'rules-broken': { readonly errors: number };
  /** Reserved values, or against the specification's advice. */
  'against-advice': { readonly warnings: number };
  // What else is known
  'answers-request': object;
  /** A request is known, but this does not answer it. */
  'answers-another': object;
  /** The bytes are those of the known request, or its first ones. */
  'repeats-request': object;
  'direction-given': object;
  'transport-given': object;
  /** Request and reply of this function look the same. */
  'same-either-way': object;
}

export type ReasonCode = keyof ReasonData;

/** One thing that speaks for a reading, or against it. */
export type Reason = { [C in ReasonCode]: { readonly code: C } & ReasonData[C] }[ReasonCode];

/** The most bytes by which a truncated frame, or one with stray bytes, may differ in length. */
const NEAR = 2;

const near = (number: number, close: number, far: number) => (number <= NEAR ? close : far);

/** Bits, roughly: what random bytes rarely do speaks for a reading. Whole numbers, so that equal evidence is equal. */
const WEIGHTS: { readonly [C in ReasonCode]: number | ((reason: ReasonData[C]) => number) } = {
  'checksum-holds': ({ algorithm }) => (algorithm === 'crc' ? 16 : 8),
  'checksum-wrong': -3,
  // A serial request for two items from address 0 looks like an MBAP of length 2.
  'mbap-fits': ({ length }) => (length === 2 ? 6 : 12),
  'mbap-length-differs': 3,
  'no-mbap': -16,
  colon: 6,
  'no-colon': -6,
  'hex-digits': 8,
  'other-characters': ({ others }) => near(others, 4, -16),
  'bare-pdu': ({ fits }) => (fits ? -3 : -9),
  'frame-inside': -2,
  'known-function': 3,
  'function-serial-only': 0,
  'unknown-function': -3,
  'fields-fit': 5,
  'byte-count-fits': 5,
  'fields-do-not-fit': -3,
  'length-short': ({ missing }) => near(missing, -1, -3),
  'length-extra': ({ bytes }) => near(bytes, -2, -4),
  'rules-broken': -3,
  'against-advice': -1,
  'answers-request': 8,
  'answers-another': 1,
  'repeats-request': 5,
  'direction-given': 5,
  'transport-given': 5,
  'same-either-way': 0,
};

/** The weight of a reason for a reading; negative if it speaks against it. */
export function weightOf<C extends ReasonCode>(reason: { readonly code: C } & ReasonData[C]): number {
  const weight = WEIGHTS[reason.code];
  return typeof weight === 'number' ? weight : weight(reason);
}
