/** A number is whole for bits and BCD; integers of up to 48 bits and floats are numbers, of 64 bits bigints. Dates and addresses are texts. */
export type Value = number | bigint | string;

type NumberKind = 'integer' | 'float' | 'bcd' | 'bits';

/** How a type of number lies in its bytes, high byte first. */
export interface NumberType {
  readonly kind: NumberKind;
  readonly registers: 1 | 2 | 3 | 4;
  /** The least and the most it holds, for floats of finite numbers. */
  readonly least: number | bigint;
  readonly most: number | bigint;
  /** Significant decimal digits with which a scaled number of the type is shown. */
  readonly digits: number;
  /** It has only some bytes of its registers; the others are not its own, and written as 0. */
  readonly partial?: boolean;
  /** It has no NaN and no infinities, though it is a float. */
  readonly finite?: boolean;
  /** `undefined` if the bytes hold no such number. */
  read(view: DataView): number | bigint | undefined;
  write(view: DataView, value: number | bigint): void;
}

/** A type of numbers with a fraction. */
export interface FloatType extends NumberType {
  readonly kind: 'float';
}

/** A type of whole numbers, read and written as bigints. */
export interface NumberTypeSpec {
  readonly kind: NumberKind;
  readonly registers: NumberType['registers'];
  readonly least: bigint;
  readonly most: bigint;
  read(view: DataView): bigint | undefined;
  write(view: DataView, value: bigint): void;
}

const DOUBLE_DIGITS = 15;

/** A type of whole numbers, which are bigints only if they have four registers. */
export function numberType({ kind, registers, least, most, read, write }: NumberTypeSpec): NumberType {
  const held = registers === 4 ? (value: bigint) => value : Number;
  return {
    kind,
    registers,
    least: held(least),
    most: held(most),
    digits: DOUBLE_DIGITS,
    read: (view) => {
      const value = read(view);
      return value === undefined ? undefined : held(value);
    },
    write: (view, value) => write(view, BigInt(value)),
  };
}
