import {
  type NumberTypeName,
  numberTypes,
  type Order,
  orders,
  plainTypeNames,
  registerPlaces,
  type ValueType,
} from '../../modbus/index.ts';
import { binary, convert, type Expression, number, type Routine } from '../code.ts';
import type { Envelope } from './envelope.ts';
import {
  byte,
  call,
  declare,
  giveBack,
  int,
  loop,
  name,
  plus,
  set,
  signed,
  times,
  toInt,
  when,
  wordOf,
} from './terms.ts';

const BITS = 8;

/** The places of a value's bytes, the highest first, from the place of its first register on. */
function placesOf(registers: number, order: Order): readonly number[] {
  const { lowByteFirst } = orders[order];
  const places = registerPlaces(order, registers).map((place) => 2 * place);
  return places.flatMap((at) => (lowByteFirst ? [at + 1, at] : [at, at + 1]));
}

/** Bytes as one number, the highest first. */
const dwordOf = (bytes: readonly Expression[]): Expression =>
  bytes
    .map((one, index) => {
      const wide = convert('dword', one);
      const shift = BITS * (bytes.length - 1 - index);
      return shift === 0 ? wide : binary(wide, '<<', int(shift));
    })
    .reduce((sum, one) => binary(sum, '|', one));

/** Types that programs take out of a reply; the others stand in its list only. */
export const takenTypes: ReadonlySet<ValueType> = new Set(plainTypeNames);

/**
 * The value that registers of a reply hold, from a place on: an `int`, of `u32` a `dword`, of floats and 64 bits a `real`.
 * BCD with a digit above 9 is below 0.
 */
export function numberAt(envelope: Envelope, at: Expression, type: NumberTypeName, order: Order): Expression {
  const { registers, kind } = numberTypes[type];
  const bytes = placesOf(registers, order).map((place) => envelope.byteAt('reply', plus(at, int(place))));
  if (type === 'f64') return floatOf64(bytes);
  if (registers === 4) return wholeOf64(bytes, type === 'i64');
  const wide = dwordOf(bytes);
  if (type === 'f16') return floatOf16(wide);
  if (kind === 'bcd') return call('int', 'bcd value', wide);
  if (kind === 'float') return { kind: 'float', type: 'real', of: wide };
  if (registers === 2) return type === 'i32' ? signed(wide) : wide;
  const word = wordOf(bytes[0] ?? byte(0), bytes[1] ?? byte(0));
  return type === 'i16' ? signed(word) : toInt(word);
}

/** A number of 64 bits, to the nearest `real`. */
function wholeOf64(bytes: readonly Expression[], isSigned: boolean): Expression {
  const [high, low] = [dwordOf(bytes.slice(0, 4)), dwordOf(bytes.slice(4))];
  const top = convert('real', isSigned ? signed(high) : high);
  return binary(binary(top, '*', number('real', 2 ** 32)), '+', convert('real', low));
}

/** The bits of a number from one on, as an `int`. */
const bitsOf = (of: Expression, from: number, many: number): Expression => {
  const moved = from === 0 ? of : binary(of, '>>', int(from));
  return toInt(binary(moved, '&', number('dword', 2 ** many - 1)));
};

const isSet = (of: Expression, bit: number): Expression =>
  binary(binary(of, '&', number('dword', 2 ** bit)), '≠', number('dword', 0));

/** A float of 64 bits; a `real` of 32 bits has fewer digits. */
function floatOf64(bytes: readonly Expression[]): Expression {
  const [high, low] = [dwordOf(bytes.slice(0, 4)), dwordOf(bytes.slice(4))];
  const top = binary(convert('real', bitsOf(high, 0, 20)), '*', number('real', 2 ** 32));
  const fraction = binary(binary(top, '+', convert('real', low)), '/', number('real', 2 ** 52));
  return call('real', 'float of parts', isSet(high, 31), bitsOf(high, 20, 11), int(1023), fraction);
}

/** A float of 16 bits. */
function floatOf16(of: Expression): Expression {
  const fraction = binary(convert('real', bitsOf(of, 0, 10)), '/', number('real', 2 ** 10));
  return call('real', 'float of parts', isSet(of, 15), bitsOf(of, 10, 5), int(15), fraction);
}

const [exponent, bias] = [name('int', 'exponent'), name('int', 'bias')];
const [fraction, value] = [name('real', 'fraction'), name('real', 'value')];
const real = (of: number) => number('real', of);
const floatOf = (bits: number): Expression => ({ kind: 'float', type: 'real', of: number('dword', bits) });
const steps = (from: Expression, to: Expression, factor: number) =>
  loop('step', from, to, [set(value, binary(value, '*', real(factor)))]);

/** `float of parts(negative, exponent, bias, fraction) → real`, as in IEEE 754. */
const floatOfParts: Routine = {
  name: 'float of parts',
  about: ['A floating-point number by the parts of its IEEE 754 form.'],
  parameters: [
    { name: 'negative', type: 'bool', comment: 'the sign' },
    { name: 'exponent', type: 'int', comment: 'as it stands in the number' },
    { name: 'bias', type: 'int', comment: 'what the exponent counts from' },
    { name: 'fraction', type: 'real', comment: 'what stands behind the point, from 0 to below 1' },
  ],
  gives: { kind: 'value', type: 'real' },
  body: [
    when(binary(exponent, '>', binary(int(2), '*', bias)), [
      when(binary(fraction, '>', real(0)), [giveBack(floatOf(0x7fc0_0000))]),
      when(name('bool', 'negative'), [giveBack(floatOf(0xff80_0000))]),
      giveBack(floatOf(0x7f80_0000)),
    ]),
    declare('value', fraction, true),
    when(
      binary(exponent, '>', int(0)),
      [set(value, binary(value, '+', real(1)))],
      [set(value, binary(value, '*', real(2)))],
    ),
    steps(bias, exponent, 2),
    steps(exponent, bias, 0.5),
    when(name('bool', 'negative'), [giveBack(binary(real(0), '-', value))]),
    giveBack(value),
  ],
};

const digits = name('dword', 'digits');
const DIGITS = 8;
const index = name('int', 'index');

/** `bcd value(digits) → int`: -1 if a digit is above 9. */
const bcdValue: Routine = {
  name: 'bcd value',
  about: ['The number whose decimal digits are those of this hexadecimal number; -1 if one is above 9.'],
  parameters: [{ name: 'digits', type: 'dword', comment: 'four bits a digit' }],
  gives: { kind: 'value', type: 'int' },
  body: [
    { kind: 'declare', name: 'value', value: int(0), changes: true },
    {
      kind: 'for',
      name: 'index',
      from: int(0),
      to: int(DIGITS),
      body: [
        {
          kind: 'declare',
          name: 'digit',
          value: toInt(
            binary(
              binary(digits, '>>', binary(int(4), '*', binary(int(DIGITS - 1), '-', index))),
              '&',
              number('dword', 0xf),
            ),
          ),
          changes: false,
        },
        when(binary(name('int', 'digit'), '>', int(9)), [giveBack(int(-1))]),
        { kind: 'set', to: name('int', 'value'), value: plus(times(10, name('int', 'value')), name('int', 'digit')) },
      ],
    },
    giveBack(name('int', 'value')),
  ],
};

/** What numbers of a reply may need. */
export const numberRoutines: readonly Routine[] = [bcdValue, floatOfParts];
