/** What a value is made of. `bits` is 16 named bits of a register, or the elements of a table of bits. */
export type ValueType = (typeof valueTypes)[number];
export const valueTypes = [
  'u16',
  'i16',
  'u32',
  'i32',
  'u64',
  'i64',
  'f16',
  'f32',
  'f64',
  'bcd16',
  'bcd32',
  'bits',
  'text',
] as const;

/** Order of the bytes of a value of two registers; in longer ones CDAB reverses registers, BADC the bytes of each, DCBA both. */
export type ByteOrder = (typeof byteOrders)[number];
export const byteOrders = ['ABCD', 'CDAB', 'BADC', 'DCBA'] as const;

/** Registers of 16 bits that one value takes; of text, each register is counted by itself. */
const WORDS: Readonly<Record<ValueType, number>> = {
  u16: 1,
  i16: 1,
  u32: 2,
  i32: 2,
  u64: 4,
  i64: 4,
  f16: 1,
  f32: 2,
  f64: 4,
  bcd16: 1,
  bcd32: 2,
  bits: 1,
  text: 1,
};

export const wordsOf = (type: ValueType): number => WORDS[type];

export type RawValue = number | bigint | string;

/**
 * The value that registers hold, of which there are as many as `wordsOf` says, or any number of text; `undefined` where
 * BCD has a digit above 9.
 */
export function readValue(words: readonly number[], type: ValueType, order: ByteOrder): RawValue | undefined {
  const bytes = new Uint8Array(2 * words.length);
  const backwards = (order === 'CDAB' || order === 'DCBA') && type !== 'text';
  const swapped = order === 'BADC' || order === 'DCBA';
  for (const [index, word] of words.entries()) {
    const at = 2 * (backwards ? words.length - 1 - index : index);
    bytes[at + (swapped ? 1 : 0)] = word >>> 8;
    bytes[at + (swapped ? 0 : 1)] = word & 0xff;
  }
  const view = new DataView(bytes.buffer);
  switch (type) {
    case 'u16':
    case 'bits':
      return view.getUint16(0);
    case 'i16':
      return view.getInt16(0);
    case 'u32':
      return view.getUint32(0);
    case 'i32':
      return view.getInt32(0);
    case 'u64':
      return view.getBigUint64(0);
    case 'i64':
      return view.getBigInt64(0);
    case 'f16':
      return halfFloat(view.getUint16(0));
    case 'f32':
      return view.getFloat32(0);
    case 'f64':
      return view.getFloat64(0);
    case 'bcd16':
      return bcd(view.getUint16(0));
    case 'bcd32':
      return bcd(view.getUint32(0));
    case 'text':
      return String.fromCharCode(...bytes).replace(/[\0 ]+$/, '');
  }
}

function halfFloat(bits: number): number {
  const sign = bits & 0x8000 ? -1 : 1;
  const exponent = (bits >>> 10) & 0x1f;
  const fraction = bits & 0x3ff;
  if (exponent === 0x1f) return fraction === 0 ? sign * Number.POSITIVE_INFINITY : Number.NaN;
  return exponent === 0 ? sign * fraction * 2 ** -24 : sign * (1 + fraction / 1024) * 2 ** (exponent - 15);
}

function bcd(value: number): number | undefined {
  const digits = value.toString(16);
  return /^\d+$/.test(digits) ? Number(digits) : undefined;
}
