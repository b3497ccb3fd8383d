import { toHex } from '../hex.ts';
import { readHalf, writeHalf } from './half.ts';

/** A number is whole for `bits` and BCD; integers of up to 32 bits and floats are numbers, of 64 bits bigints. */
export type Value = number | bigint | string;

type NumberKind = 'integer' | 'float' | 'bcd' | 'bits';

/** How a type of number lies in its bytes, high byte first. */
export interface NumberType {
  readonly kind: NumberKind;
  readonly registers: 1 | 2 | 4;
  /** The least and the most it holds, for floats of finite numbers. */
  readonly least: number | bigint;
  readonly most: number | bigint;
  /** Significant decimal digits with which a scaled number of the type is shown. */
  readonly digits: number;
  read(view: DataView): number | bigint;
  write(view: DataView, value: number | bigint): void;
}

/** A floating-point type of IEEE 754. */
export interface FloatType extends NumberType {
  readonly kind: 'float';
}

const { MAX_VALUE } = Number;
/** Significant decimal digits that a number of the program keeps. */
const DOUBLE_DIGITS = 15;
const F32_MOST = (2 - 2 ** -23) * 2 ** 127;

const small = (
  registers: 1 | 2,
  [least, most]: readonly [number, number],
  read: (view: DataView) => number,
  write: (view: DataView, value: number) => void,
  kind: NumberKind = 'integer',
): NumberType => ({
  kind,
  registers,
  least,
  most,
  digits: DOUBLE_DIGITS,
  read,
  write: (view, value) => write(view, Number(value)),
});

const big = (
  [least, most]: readonly [bigint, bigint],
  read: (view: DataView) => bigint,
  write: (view: DataView, value: bigint) => void,
): NumberType => ({
  kind: 'integer',
  registers: 4,
  least,
  most,
  digits: DOUBLE_DIGITS,
  read,
  write: (view, value) => write(view, BigInt(value)),
});

const float = (
  registers: 1 | 2 | 4,
  most: number,
  digits: number,
  read: (view: DataView) => number,
  write: (view: DataView, value: number) => void,
): FloatType => ({
  kind: 'float',
  digits,
  registers,
  least: -most,
  most,
  read,
  write: (view, value) => write(view, Number(value)),
});

/** Binary coded decimal: four bits a digit. Digits above 9 are looked for before it is read. */
const bcd = (registers: 1 | 2): NumberType => {
  const digits = 4 * registers;
  return {
    kind: 'bcd',
    registers,
    least: 0,
    most: 10 ** digits - 1,
    digits: DOUBLE_DIGITS,
    read: (view) => Number(hexOf(view)),
    write: (view, value) => {
      const text = String(value).padStart(digits, '0');
      for (let at = 0; at < view.byteLength; at++)
        view.setUint8(at, Number.parseInt(text.slice(2 * at, 2 * at + 2), 16));
    },
  };
};

/** The bytes of a view as hexadecimal digits. */
export const hexOf = (view: DataView): string => toHex(new Uint8Array(view.buffer, view.byteOffset, view.byteLength));

/** Every type of number that registers hold. */
export const numberTypes = {
  u16: small(
    1,
    [0, 0xffff],
    (view) => view.getUint16(0),
    (view, value) => view.setUint16(0, value),
  ),
  i16: small(
    1,
    [-0x8000, 0x7fff],
    (view) => view.getInt16(0),
    (view, value) => view.setInt16(0, value),
  ),
  f16: float(
    1,
    65504,
    4,
    (view) => readHalf(view.getUint16(0)),
    (view, value) => view.setUint16(0, writeHalf(value)),
  ),
  bcd16: bcd(1),
  bits: small(
    1,
    [0, 0xffff],
    (view) => view.getUint16(0),
    (view, value) => view.setUint16(0, value),
    'bits',
  ),
  u32: small(
    2,
    [0, 0xffff_ffff],
    (view) => view.getUint32(0),
    (view, value) => view.setUint32(0, value),
  ),
  i32: small(
    2,
    [-(2 ** 31), 2 ** 31 - 1],
    (view) => view.getInt32(0),
    (view, value) => view.setInt32(0, value),
  ),
  f32: float(
    2,
    F32_MOST,
    7,
    (view) => view.getFloat32(0),
    (view, value) => view.setFloat32(0, value),
  ),
  bcd32: bcd(2),
  u64: big(
    [0n, 2n ** 64n - 1n],
    (view) => view.getBigUint64(0),
    (view, value) => view.setBigUint64(0, value),
  ),
  i64: big(
    [-(2n ** 63n), 2n ** 63n - 1n],
    (view) => view.getBigInt64(0),
    (view, value) => view.setBigInt64(0, value),
  ),
  f64: float(
    4,
    MAX_VALUE,
    DOUBLE_DIGITS,
    (view) => view.getFloat64(0),
    (view, value) => view.setFloat64(0, value),
  ),
} as const satisfies Readonly<Record<string, NumberType>>;

export type NumberTypeName = keyof typeof numberTypes;
export type FloatTypeName = {
  [Name in NumberTypeName]: (typeof numberTypes)[Name] extends FloatType ? Name : never;
}[NumberTypeName];
export type ValueType = NumberTypeName | 'text';

/** Significant decimal digits with which a scaled value of a type is shown. */
export const shownDigits = (type: ValueType): number => (type === 'text' ? DOUBLE_DIGITS : numberTypes[type].digits);

export const numberTypeNames = Object.keys(numberTypes) as readonly NumberTypeName[];

/** Whether a type holds numbers. */
export const isNumberType = (type: ValueType): type is NumberTypeName => type !== 'text';
