import {
  type Fraction,
  fraction,
  numberTypes,
  type Order,
  orders,
  rawExactly,
  type Scale,
  subtract,
  toNumber,
  toRaw,
  unitsExactly,
} from '../../modbus/index.ts';
import type { UnitScale } from '../../notation/index.ts';
import { binary, convert, type Expression, type Name, number, type Routine } from '../code.ts';
import { declare, giveBack, name, set, when } from './terms.ts';

/** A straight line: `times × n + plus`. */
interface Line {
  readonly times: Fraction;
  readonly plus: Fraction;
}

/** The line that a way from one number to another is, found by asking it for 0 and 1. */
function lineOf(way: (n: Fraction) => Fraction): Line {
  const at0 = way(fraction(0));
  return { times: subtract(way(fraction(1)), at0), plus: at0 };
}

const real = (value: Fraction | number): Expression =>
  number('real', typeof value === 'number' ? value : toNumber(value));
const isZero = ({ numerator }: Fraction): boolean => numerator === 0n;

/** A number on the line, as a `real`: multiplied first, so that what is whole stays exact. */
function onLine(of: Expression, { times, plus }: Line): Expression {
  const { numerator, denominator } = times;
  const multiplied = numerator === 1n ? of : binary(of, '*', real(Number(numerator)));
  const scaled = denominator === 1n ? multiplied : binary(multiplied, '/', real(Number(denominator)));
  if (isZero(plus)) return scaled;
  const isLess = plus.numerator < 0n;
  return binary(scaled, isLess ? '-' : '+', real(isLess ? { ...plus, numerator: -plus.numerator } : plus));
}

/** A raw number in units, as a `real`. */
export const unitsTerm = (raw: Expression, { scale }: UnitScale): Expression =>
  onLine(
    convert('real', raw),
    lineOf((n) => unitsExactly(n, scale)),
  );

/** Whether values of a line in units can be written into one register by a program. */
export const isWritable = ({ type, order }: { readonly type: UnitScale['type']; readonly order: Order }): boolean =>
  (type === 'u16' || type === 'i16') && !orders[order].lowByteFirst;

/** More than the error of a `real`, less than what is between two values of few decimals. */
const NEARLY_HALF = 0.5 + 1e-9;

/** `(units) → word`: the nearest raw number, halves away from 0, within what the register holds. */
export function toRawRoutine({ scale, type, unit }: UnitScale, called: Name): Routine {
  const exact = name('real', 'exact');
  const raw = name('real', 'raw');
  const [least, most] = [Number(numberTypes[type].least), Number(numberTypes[type].most)];
  const floor = (of: Expression): Expression => ({ kind: 'floor', type: 'real', of });
  const word = (of: number) => giveBack(number('word', of & 0xffff));
  return {
    name: called,
    about: [`The raw number for a value in ${unit}: the nearest one, halves away from 0, from ${least} to ${most}.`],
    parameters: [{ name: 'units', type: 'real', comment: unit }],
    gives: { kind: 'value', type: 'word' },
    body: [
      declare(
        'exact',
        onLine(
          name('real', 'units'),
          lineOf((n) => rawExactly(n, scale)),
        ),
        false,
      ),
      declare('raw', floor(binary(exact, '+', real(NEARLY_HALF))), true),
      when(binary(exact, '<', real(0)), [set(raw, binary(real(0), '-', floor(binary(real(NEARLY_HALF), '-', exact))))]),
      when(binary(raw, '<', real(least)), [word(least)]),
      when(binary(raw, '>', real(most)), [word(most)]),
      giveBack(convert('word', convert('int', raw))),
    ],
  };
}

const MOST_DECIMALS = 12;

/** A raw number in units, with as few decimals as are shown and bring it back. */
export function typedInUnits(raw: number, scale: Scale): number {
  const exactly = unitsExactly(fraction(raw), scale);
  for (let decimals = scale.decimals; decimals < MOST_DECIMALS; decimals++) {
    const typed = Number(toNumber(exactly).toFixed(decimals));
    const power = 10n ** BigInt(decimals);
    const whole = fraction(BigInt(Math.round(typed * Number(power))), power);
    const back = toRaw(whole, { ...scale, least: undefined, most: undefined });
    if (back.kind === 'raw' && back.raw === BigInt(raw)) return typed;
  }
  return toNumber(exactly);
}
