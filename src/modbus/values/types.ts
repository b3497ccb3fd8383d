import { type FormTypeName, formTypes, type TextTypeName, textTypes } from './form-types.ts';
import { readHalf, writeHalf } from './half.ts';
import { bcd, signedBcd } from './kernels/bcd.ts';
import { decimalFloat } from './kernels/decimal-float.ts';
import { mod10k } from './kernels/mod10k.ts';
import { type FloatType, type NumberType, numberType } from './number-type.ts';

const { MAX_VALUE } = Number;
/** Significant decimal digits that a number of the program keeps. */
const DOUBLE_DIGITS = 15;
const F32_MOST = (2 - 2 ** -23) * 2 ** 127;

/** Whole numbers of these bytes, high byte first; they may be a part of the registers that they stand in. */
function integer(
  registers: NumberType['registers'],
  [from, to]: readonly [number, number],
  isSigned: boolean,
): NumberType {
  if (registers === 4) return integer64(isSigned);
  const span = 2 ** (8 * (to - from));
  const [least, most] = isSigned ? [-span / 2, span / 2 - 1] : [0, span - 1];
  const read = (view: DataView): number => {
    let value = 0;
    for (let at = from; at < to; at++) value = 256 * value + view.getUint8(at);
    return value > most ? value - span : value;
  };
  const write = (view: DataView, value: number | bigint) => {
    let rest = Number(value) < 0 ? Number(value) + span : Number(value);
    for (let at = to - 1; at >= from; at--, rest = Math.floor(rest / 256)) view.setUint8(at, rest % 256);
  };
  const partial = to - from < 2 * registers;
  return { kind: 'integer', registers, least, most, digits: DOUBLE_DIGITS, ...(partial && { partial }), read, write };
}

const integer64 = (isSigned: boolean): NumberType =>
  numberType({
    kind: 'integer',
    registers: 4,
    least: isSigned ? -(2n ** 63n) : 0n,
    most: isSigned ? 2n ** 63n - 1n : 2n ** 64n - 1n,
    read: (view) => (isSigned ? view.getBigInt64(0) : view.getBigUint64(0)),
    write: (view, value) => view.setBigUint64(0, BigInt.asUintN(64, value)),
  });

const whole = (registers: NumberType['registers'], isSigned: boolean): NumberType =>
  integer(registers, [0, 2 * registers], isSigned);

/** The highest bit is the sign, the others are the size. */
function signAndMagnitude(registers: 1 | 2): NumberType {
  const sign = 2n ** BigInt(16 * registers - 1);
  const { read, write } = whole(registers, false);
  return numberType({
    kind: 'integer',
    registers,
    least: 1n - sign,
    most: sign - 1n,
    read: (view) => {
      const bits = BigInt(read(view) ?? 0);
      return bits < sign ? bits : sign - bits;
    },
    write: (view, value) => write(view, value < 0n ? sign - value : value),
  });
}

const bits = (registers: 1 | 2 | 4): NumberType => ({ ...whole(registers, false), kind: 'bits' });

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

/** Every type of number that registers hold. */
export const numberTypes = {
  u16: whole(1, false),
  i16: whole(1, true),
  f16: float(
    1,
    65504,
    4,
    (view) => readHalf(view.getUint16(0)),
    (view, value) => view.setUint16(0, writeHalf(value)),
  ),
  bcd16: bcd(1),
  bits: bits(1),
  u32: whole(2, false),
  i32: whole(2, true),
  f32: float(
    2,
    F32_MOST,
    7,
    (view) => view.getFloat32(0),
    (view, value) => view.setFloat32(0, value),
  ),
  bcd32: bcd(2),
  u64: whole(4, false),
  i64: whole(4, true),
  f64: float(
    4,
    MAX_VALUE,
    DOUBLE_DIGITS,
    (view) => view.getFloat64(0),
    (view, value) => view.setFloat64(0, value),
  ),
  u8h: integer(1, [0, 1], false),
  u8l: integer(1, [1, 2], false),
  i8h: integer(1, [0, 1], true),
  i8l: integer(1, [1, 2], true),
  sm16: signAndMagnitude(1),
  sbcd16: signedBcd(1),
  bits32: bits(2),
  u24: integer(2, [1, 4], false),
  i24: integer(2, [1, 4], true),
  sm32: signAndMagnitude(2),
  sbcd32: signedBcd(2),
  mod10k2: mod10k(2),
  e8m24: decimalFloat,
  u48: whole(3, false),
  i48: whole(3, true),
  mod10k3: mod10k(3),
  bits64: bits(4),
  bcd64: bcd(4),
  mod10k4: mod10k(4),
} as const satisfies Readonly<Record<string, NumberType>>;

export type NumberTypeName = keyof typeof numberTypes;
export type FloatTypeName = {
  [Name in NumberTypeName]: (typeof numberTypes)[Name] extends FloatType ? Name : never;
}[NumberTypeName];
export type ValueType = NumberTypeName | FormTypeName | TextTypeName;

/** Whether a type holds numbers. */
export const isNumberType = (type: ValueType): type is NumberTypeName => Object.hasOwn(numberTypes, type);

/** Whether a type is a text, which has as many registers as it is given. */
export const isTextType = (type: ValueType): type is TextTypeName => Object.hasOwn(textTypes, type);

/** Whether a type is a text of a form of its own: a date, an address. */
export const isFormType = (type: ValueType): type is FormTypeName => Object.hasOwn(formTypes, type);

/** The registers that one value of a type takes; of a text, each register is counted by itself. */
export const registersOf = (type: ValueType): number =>
  isNumberType(type) ? numberTypes[type].registers : isFormType(type) ? formTypes[type].registers : 1;

/** Whether a type has only some bytes of its registers. */
export const isPartial = (type: NumberTypeName): boolean => (numberTypes[type] as NumberType).partial === true;

/** Whether numbers of a type are bigints: of 64 bits. */
export const isBig = (type: NumberTypeName): boolean =>
  numberTypes[type].kind !== 'float' && numberTypes[type].registers === 4;

/** Significant decimal digits with which a scaled value of a type is shown. */
export const shownDigits = (type: ValueType): number => (isNumberType(type) ? numberTypes[type].digits : DOUBLE_DIGITS);

export const numberTypeNames = Object.keys(numberTypes) as readonly NumberTypeName[];
/** The types that most devices have. */
export const plainTypeNames = numberTypeNames.slice(0, numberTypeNames.indexOf('u8h'));
export const formTypeNames = Object.keys(formTypes) as readonly FormTypeName[];
export const textTypeNames = Object.keys(textTypes) as readonly TextTypeName[];
export const valueTypeNames: readonly ValueType[] = [...numberTypeNames, ...textTypeNames, ...formTypeNames];
