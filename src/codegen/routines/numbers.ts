import { type NumberTypeName, numberTypes, type Order, orders } from '../../modbus/index.ts';
import { binary, convert, type Expression, number, type Routine } from '../code.ts';
import type { Envelope } from './envelope.ts';
import { call, giveBack, int, name, plus, signed, times, toInt, when, wordOf } from './terms.ts';

const BITS = 8;

/** The places of a value's bytes, the highest first, from the place of its first register on. */
function placesOf(registers: number, order: Order): readonly number[] {
  const { lowRegisterFirst, lowByteFirst } = orders[order];
  const places = Array.from(
    { length: registers },
    (_, index) => 2 * (lowRegisterFirst ? registers - 1 - index : index),
  );
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

/**
 * The value that registers of a reply hold, from a place on: an `int`, of `u32` a `dword`, of `f32` and 64 bits a `real`.
 * `undefined` for types that `Code` has no numbers for. BCD with a digit above 9 is below 0.
 */
export function numberAt(
  envelope: Envelope,
  at: Expression,
  type: NumberTypeName,
  order: Order,
): Expression | undefined {
  const { registers, kind } = numberTypes[type];
  const bytes = placesOf(registers, order).map((place) => envelope.byteAt('reply', plus(at, int(place))));
  const [first, second] = bytes;
  if (first === undefined || second === undefined || type === 'f16' || type === 'f64') return undefined;
  if (registers === 4) return wholeOf64(bytes, type === 'i64');
  const raw = registers === 1 ? wordOf(first, second) : dwordOf(bytes);
  if (kind === 'bcd') return call('int', 'bcd value', convert('dword', raw));
  if (kind === 'float') return { kind: 'float', type: 'real', of: raw };
  if (type === 'i16' || type === 'i32') return signed(raw);
  return registers === 1 ? toInt(raw) : raw;
}

/** A number of 64 bits, to the nearest `real`. */
function wholeOf64(bytes: readonly Expression[], isSigned: boolean): Expression {
  const [high, low] = [dwordOf(bytes.slice(0, 4)), dwordOf(bytes.slice(4))];
  const top = convert('real', isSigned ? signed(high) : high);
  return binary(binary(top, '*', number('real', 2 ** 32)), '+', convert('real', low));
}

const digits = name('dword', 'digits');
const DIGITS = 8;
const index = name('int', 'index');

/** `bcd value(digits) → int`: -1 if a digit is above 9. */
export const bcdValue: Routine = {
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
